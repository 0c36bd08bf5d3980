#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace hedr {

// The secret that a robot and its laptop share.
using SigningKey = std::array<std::uint8_t, 16>;
using SigningTag = std::array<std::uint8_t, 8>;

// SipHash-2-4 (Aumasson and Bernstein 2012), the tag in the order of its bytes.
SigningTag sipHash(const SigningKey& key, std::span<const std::uint8_t> bytes);

// Takes the same time wherever they differ. `tag` has 8 bytes.
bool isTag(const SigningTag& expected, std::span<const std::uint8_t> tag);

}  // namespace hedr
