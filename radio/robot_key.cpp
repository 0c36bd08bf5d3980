#include "radio/robot_key.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "core/file_descriptor.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKeyExtension = ".key";
constexpr std::size_t kMostBytes = 4096;
constexpr mode_t kOthersMayRead = 077;
constexpr mode_t kOthersMayWrite = 022;

tl::unexpected<Error> writeFailure(const fs::path& file, int error_number) {
    const bool full = error_number == ENOSPC || error_number == EDQUOT;
    return fail(full ? ErrorCode::kDiskFull : ErrorCode::kFileUnwritable, file.string(),
                std::generic_category().message(error_number));
}

bool writeAll(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR) return false;
        text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return fsync(descriptor) == 0;
}

// The name of a new file is on the disk only when its folder is.
void syncFolderOf(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor) fsync(descriptor.get());
}

Result<void> writeNewFile(const fs::path& file, std::string_view text) {
    const FileDescriptor descriptor(
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (!descriptor && errno == EEXIST) {
        return fail(ErrorCode::kFileExists, file.string());
    }
    if (!descriptor) return writeFailure(file, errno);
    if (!writeAll(descriptor.get(), text)) {
        const int reason = errno;
        ::unlink(file.c_str());
        return writeFailure(file, reason);
    }
    syncFolderOf(file);
    return {};
}

Result<std::string> readSmallFile(const fs::path& file, mode_t forbidden) {
    // Not to wait for whoever writes to a pipe.
    const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!descriptor || fstat(descriptor.get(), &status) != 0) {
        const int reason = errno;
        return fail(reason == ENOENT ? ErrorCode::kFileMissing : ErrorCode::kFileUnreadable,
                    file.string(), reason == ENOENT ? "" : std::generic_category().message(reason));
    }
    if (!S_ISREG(status.st_mode)) {
        return fail(ErrorCode::kFileUnreadable, file.string(), "it is no plain file");
    }
    if ((status.st_mode & forbidden) != 0) return fail(ErrorCode::kKeyExposed, file.string());
    std::array<char, kMostBytes + 1> bytes{};
    std::size_t size = 0;
    ssize_t got = 1;
    while (size < bytes.size() && got != 0) {
        got = ::read(descriptor.get(), &bytes[size], bytes.size() - size);
        if (got < 0 && errno != EINTR) {
            return fail(ErrorCode::kFileUnreadable, file.string(),
                        std::generic_category().message(errno));
        }
        size += got < 0 ? 0 : static_cast<std::size_t>(got);
    }
    if (size > kMostBytes) {
        return fail(ErrorCode::kFileTooLarge, file.string(), "such a file has a few lines");
    }
    return std::string(bytes.data(), size);
}

// Whoever may write to the folder can put another key in the place of this one. /tmp and the like
// let everybody write, but nobody replace.
Result<void> checkFolderOf(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    struct stat status {};
    const bool replaceable = ::stat(folder.c_str(), &status) == 0 &&
                             (status.st_mode & kOthersMayWrite) != 0 &&
                             (status.st_mode & S_ISVTX) == 0;
    return replaceable ? fail(ErrorCode::kKeyExposed, folder.string()) : Result<void>{};
}

fs::path countersFileOf(const fs::path& key_file) {
    return fs::path(key_file).replace_extension(".counters");
}

}  // namespace

fs::path defaultKeyFolder() {
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    const bool named = data != nullptr && *data == '/';
    const fs::path base =
        named ? fs::path(data) : fs::path(home == nullptr ? "." : home) / ".local/share";
    return base / "hedr" / "keys";
}

fs::path keyFileOf(const fs::path& folder, const std::string& name) {
    return folder / (name + kKeyExtension);
}

RobotKey newKey(const std::string& name) {
    RobotKey result{name, {}};
    // It cannot fail for so few bytes on a system that has started.
    if (getentropy(result.key.data(), result.key.size()) != 0) std::abort();
    return result;
}

Result<void> writeSecretFile(const fs::path& file, std::string_view text) {
    const fs::path folder = file.parent_path();
    std::error_code error;
    if (!folder.empty() && !fs::exists(folder, error)) {
        fs::create_directories(folder, error);
        fs::permissions(folder, fs::perms::owner_all, error);
        if (error) return fail(ErrorCode::kFileUnwritable, folder.string(), error.message());
    }
    return writeNewFile(file, text);
}

Result<RobotKey> loadKey(const fs::path& file) {
    return readSmallFile(file, kOthersMayRead)
        .and_then(
            [&](const std::string& text) { return checkFolderOf(file).map([&] { return text; }); })
        .and_then([&](const std::string& text) { return parseKey(text, file.string()); });
}

StoredKeys loadKeys(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().extension() == kKeyExtension) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    StoredKeys stored;
    for (const fs::path& file : files) {
        auto key = loadKey(file);
        if (key) {
            stored.keys.push_back({file, *std::move(key)});
        } else {
            stored.refused.push_back(key.error());
            stored.refused_names.push_back(file.stem().string());
        }
    }
    return stored;
}

Result<KeyCounters> loadCounters(const fs::path& key_file) {
    const fs::path file = countersFileOf(key_file);
    const auto text = readSmallFile(file, kOthersMayWrite);
    if (!text && text.error().code == ErrorCode::kFileMissing) return KeyCounters{};
    return text.and_then(
        [&](const std::string& read) { return parseCounters(read, file.string()); });
}

Result<void> saveCounters(const fs::path& key_file, const KeyCounters& counters) {
    const fs::path file = countersFileOf(key_file);
    const fs::path draft = unusedNameBeside(file);
    if (auto written = writeNewFile(draft, countersText(counters)); !written) return written;
    if (::rename(draft.c_str(), file.c_str()) != 0) {
        const int reason = errno;
        ::unlink(draft.c_str());
        return writeFailure(file, reason);
    }
    syncFolderOf(file);
    return {};
}

std::uint32_t saidAtStart(const KeyCounters& counters, std::chrono::system_clock::time_point now) {
    constexpr std::chrono::sys_days kSince{std::chrono::year{2020} / 1 / 1};
    constexpr std::int64_t kPerSecond = 4;
    constexpr std::int64_t kLast = UINT32_MAX;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - kSince).count();
    const auto by_clock = std::clamp<std::int64_t>(seconds, 0, kLast / kPerSecond) * kPerSecond;
    return std::max(counters.said, static_cast<std::uint32_t>(by_clock));
}

}  // namespace hedr
