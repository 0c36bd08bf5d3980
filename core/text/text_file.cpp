#include "core/text/text_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace hedr {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reasonOf(int error_number) { return std::generic_category().message(error_number); }

tl::unexpected<Error> writeFailure(const fs::path& file, int error_number) {
    const bool full = error_number == ENOSPC || error_number == EDQUOT;
    return fail(full ? ErrorCode::kDiskFull : ErrorCode::kFileUnwritable, file.string(),
                reasonOf(error_number));
}

Result<void> writeInPlace(const fs::path& file, std::string_view text) {
    File out(std::fopen(file.c_str(), "wb"));
    if (!out) return writeFailure(file, errno);
    if (std::fwrite(text.data(), 1, text.size(), out.get()) != text.size())
        return writeFailure(file, errno);
    // A full disk may show only now, when the last buffer goes out.
    if (std::fclose(out.release()) != 0) return writeFailure(file, errno);
    return {};
}

// Somebody's recording may have the first name that comes to mind.
fs::path unusedNameBeside(const fs::path& target) {
    std::error_code ignored;
    for (int i = 0;; ++i) {
        fs::path draft = target;
        draft += ".part" + (i == 0 ? std::string() : std::to_string(i));
        if (!fs::exists(fs::symlink_status(draft, ignored))) return draft;
    }
}

}  // namespace

Result<std::string> readTextFile(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found)
        return fail(ErrorCode::kFileMissing, file.string());
    if (fs::is_directory(status))
        return fail(ErrorCode::kFileUnreadable, file.string(), "it is a folder");
    File in(std::fopen(file.c_str(), "rb"));
    if (!in) return fail(ErrorCode::kFileUnreadable, file.string(), reasonOf(errno));

    std::string text;
    const auto expected_size = fs::is_regular_file(status) ? fs::file_size(file, error) : 0;
    std::size_t used = 0;
    // One byte more than expected, so that the end of the file shows in the first read.
    text.resize(error ? std::size_t{4096} : static_cast<std::size_t>(expected_size) + 1);
    while (const std::size_t got =
               std::fread(text.data() + used, 1, text.size() - used, in.get())) {
        used += got;
        if (used == text.size()) text.resize(2 * text.size() + 4096);
    }
    if (std::ferror(in.get()))
        return fail(ErrorCode::kFileUnreadable, file.string(), reasonOf(errno));
    text.resize(used);
    return text;
}

Result<void> writeTextFile(const fs::path& file, std::string_view text) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status))
        return fail(ErrorCode::kFileUnwritable, file.string(), "it is a folder");
    // A device or a pipe cannot be replaced.
    if (fs::exists(status) && !fs::is_regular_file(status)) return writeInPlace(file, text);

    const fs::path target = fs::exists(status) ? fs::canonical(file, error) : file;
    const fs::path draft = unusedNameBeside(target);
    if (auto written = writeInPlace(draft, text); !written) {
        fs::remove(draft, error);
        return fail(written.error().code, file.string(), written.error().detail);
    }
    fs::rename(draft, target, error);
    if (error) return fail(ErrorCode::kFileUnwritable, file.string(), error.message());
    return {};
}

}  // namespace hedr
