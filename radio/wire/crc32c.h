#pragma once

#include <cstdint>
#include <span>

namespace hedr {

// CRC-32C (Castagnoli): reflected polynomial 0x82F63B78, start and final xor 0xFFFFFFFF.
// crc32c("123456789") is 0xE3069283.
std::uint32_t crc32c(std::span<const std::uint8_t> bytes);

}  // namespace hedr
