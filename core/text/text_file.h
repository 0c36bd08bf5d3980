#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"

namespace hedr {

// A whole file. Errors: kFileMissing, kFileUnreadable (a directory, no permission, a bad disk),
// kFileTooLarge (for the memory; a stream without an end).
Result<std::string> readTextFile(const std::filesystem::path& file);

// Some editors put a mark of three bytes before a UTF-8 text.
std::string_view withoutByteOrderMark(std::string_view text);

// A name for a draft of that file: no file has it.
std::filesystem::path unusedNameBeside(const std::filesystem::path& target);

// Replaces a file in one step: whoever reads it, or loses power, finds the old text or the new one.
// Errors: kFileUnwritable, kDiskFull.
Result<void> writeTextFile(const std::filesystem::path& file, std::string_view text);

}  // namespace hedr
