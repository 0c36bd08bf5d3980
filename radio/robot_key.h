#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include "radio/wire/signing/key_text.h"

namespace hedr {

// Keys are files NAME.key that only their owner may read, with their counters in NAME.counters
// beside them.

// $XDG_DATA_HOME/hedr/keys, or that in ~/.local/share.
std::filesystem::path defaultKeyFolder();
std::filesystem::path keyFileOf(const std::filesystem::path& folder, const std::string& name);

// A new random key.
RobotKey newKey(const std::string& name);

// Writes a file that only the owner may read (0600), and the folder for it (0700) where there is
// none. Nothing is replaced. Errors: kFileExists, kFileUnwritable, kDiskFull.
Result<void> writeSecretFile(const std::filesystem::path& file, std::string_view text);

// Errors: kFileMissing, kFileUnreadable (a pipe or a folder, too), kFileTooLarge, kBadFormat, and
// kKeyExposed where others may read it, or replace it in its folder.
Result<RobotKey> loadKey(const std::filesystem::path& file);

struct StoredKey {
    std::filesystem::path file;
    RobotKey key;
};
// Each *.key of a folder, by name; those that cannot be used, with the reason. No folder: no keys.
struct StoredKeys {
    std::vector<StoredKey> keys;
    std::vector<Error> refused;
    std::vector<std::string> refused_names;  // of their robots, as their files are called
};
StoredKeys loadKeys(const std::filesystem::path& folder);

// Of a key that was never used: zeros. Errors: those of loadKey. Damaged ones are an error, since
// with zeros instead old frames would be accepted again.
Result<KeyCounters> loadCounters(const std::filesystem::path& key_file);
// In one step that outlives a power cut. Errors: kFileUnwritable, kDiskFull.
Result<void> saveCounters(const std::filesystem::path& key_file, const KeyCounters& counters);

// What a FrameSigner starts with: behind all that was said before, also where the counters are lost
// or another laptop has the same key, as long as no clock was wrong and nobody says more than four
// frames a second for long. Fits until 2054.
std::uint32_t saidAtStart(const KeyCounters& counters, std::chrono::system_clock::time_point now);

}  // namespace hedr
