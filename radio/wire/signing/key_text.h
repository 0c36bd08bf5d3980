#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "radio/wire/signing/siphash.h"

namespace hedr {

struct RobotKey {
    std::string name;  // the robot's, as its hello says it
    SigningKey key{};
    friend bool operator==(const RobotKey&, const RobotKey&) = default;
};

// How far the counters of a key went, see FrameSigner and FrameVerifier.
struct KeyCounters {
    std::uint32_t said = 0;   // the laptop may have used all up to this
    std::uint32_t heard = 0;  // nothing of the robot's up to this is accepted
    friend bool operator==(const KeyCounters&, const KeyCounters&) = default;
};

// Why `name` can be no robot's name: it becomes a file's name and stands in quotes, and a hello has
// room for 63 bytes. Error: kBadValue.
Result<void> checkRobotName(std::string_view name);

// The texts of NAME.key and NAME.counters: TOML with a value on each line. Nothing is guessed: a
// key that is missing, twice or not known is an error (kBadFormat, with path:line).
std::string keyText(const RobotKey& key);
Result<RobotKey> parseKey(std::string_view text, const std::string& path);
std::string countersText(const KeyCounters& counters);
Result<KeyCounters> parseCounters(std::string_view text, const std::string& path);

std::string hexOf(const SigningKey& key);  // 32 digits
// A header for a robot's firmware: #define HEDR_KEY { 0x00, ... }.
std::string cHeaderOf(const RobotKey& key);

}  // namespace hedr
