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

// Replaces a file in one step: whoever reads it, or kills the program, finds the old text or the
// new one, with the old file's mode and, where that may be, its owner. Errors: kFileUnwritable
// (also where the old one is protected from the user), kDiskFull.
Result<void> writeTextFile(const std::filesystem::path& file, std::string_view text);

}  // namespace hedr
