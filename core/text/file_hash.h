#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/result.h"

namespace hedr {

// Called with the share that is done; false: stop.
using HashProgress = std::function<bool(double)>;

// SHA-256 of a file's bytes, 64 hexadecimal digits. Read piece by piece: memory does not grow with
// the file. Errors: kFileMissing, kFileUnreadable, kCanceled.
Result<std::string> fileHash(const std::filesystem::path& file, const HashProgress& progress = {});

}  // namespace hedr
