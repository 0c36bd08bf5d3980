#include "core/text/text_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
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

// A pipe may bring a long log, but /dev/zero never ends.
constexpr std::size_t kMostFromAStream = std::size_t{1} << 30;
constexpr std::size_t kFirstRead = 4095;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// What is read from a text takes as much room again.
std::uintmax_t halfOfMemory() {
    return static_cast<std::uintmax_t>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE)) / 2;
}

std::string reasonOf(int error_number) { return std::generic_category().message(error_number); }

tl::unexpected<Error> writeFailure(const fs::path& file, int error_number) {
    const bool full = error_number == ENOSPC || error_number == EDQUOT;
    return fail(full ? ErrorCode::kDiskFull : ErrorCode::kFileUnwritable, file.string(),
                reasonOf(error_number));
}

Result<void> writeInPlace(const fs::path& file, std::string_view text, const char* mode = "wb") {
    File out(std::fopen(file.c_str(), mode));
    if (!out) return writeFailure(file, errno);
    if (std::fwrite(text.data(), 1, text.size(), out.get()) != text.size())
        return writeFailure(file, errno);
    // A full disk may show only now, when the last buffer goes out.
    if (std::fclose(out.release()) != 0) return writeFailure(file, errno);
    return {};
}

Result<std::string> readAll(std::FILE* in, const fs::path& file, bool regular) {
    std::error_code error;
    std::uintmax_t expected_size = fs::file_size(file, error);
    if (!regular || error) expected_size = kFirstRead;
    if (expected_size > halfOfMemory())
        return fail(ErrorCode::kFileTooLarge, file.string(), "it does not fit into memory");
    std::string text;
    std::size_t used = 0;
    // One byte more than expected, so that the end of the file shows in the first read.
    text.resize(static_cast<std::size_t>(expected_size) + 1);
    while (const std::size_t got = std::fread(text.data() + used, 1, text.size() - used, in)) {
        used += got;
        if (!regular && used > kMostFromAStream)
            return fail(ErrorCode::kFileTooLarge, file.string(), "no end after 1 GB");
        if (used == text.size()) text.resize(2 * text.size());
    }
    if (std::ferror(in) != 0)
        return fail(ErrorCode::kFileUnreadable, file.string(), reasonOf(errno));
    text.resize(used);
    return text;
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

    return readAll(in.get(), file, fs::is_regular_file(status));
}

std::string_view withoutByteOrderMark(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    return text;
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

namespace {

// Two programs may be at the same file: each has a draft of its own.
Result<fs::path> writtenDraft(const fs::path& target, std::string_view text) {
    for (;;) {
        fs::path draft = unusedNameBeside(target);
        errno = 0;
        const auto written = writeInPlace(draft, text, "wbx");
        if (written) return draft;
        if (errno == EEXIST) continue;
        std::error_code ignored;
        fs::remove(draft, ignored);
        return tl::make_unexpected(written.error());
    }
}

// Who may read and write a file stays so, as far as the user may say it.
void takeOver(const fs::path& from, const fs::path& to) {
    struct stat old {};
    if (stat(from.c_str(), &old) != 0) return;
    (void)!chown(to.c_str(), old.st_uid, old.st_gid);
    (void)!chmod(to.c_str(), old.st_mode & 07777U);
}

}  // namespace

Result<void> writeTextFile(const fs::path& file, std::string_view text) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status))
        return fail(ErrorCode::kFileUnwritable, file.string(), "it is a folder");
    // A device or a pipe cannot be replaced.
    if (fs::exists(status) && !fs::is_regular_file(status)) return writeInPlace(file, text);

    const bool replaces = fs::exists(status);
    if (replaces && access(file.c_str(), W_OK) != 0) return writeFailure(file, errno);
    const fs::path target = replaces ? fs::canonical(file, error) : file;
    const auto draft = writtenDraft(target, text);
    if (!draft) return fail(draft.error().code, file.string(), draft.error().detail);
    if (replaces) takeOver(target, *draft);
    fs::rename(*draft, target, error);
    if (!error) return {};
    std::error_code ignored;
    fs::remove(*draft, ignored);
    return fail(ErrorCode::kFileUnwritable, file.string(), error.message());
}

}  // namespace hedr
