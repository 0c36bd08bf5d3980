#pragma once

#include <cstdint>
#include <span>

namespace hedr {

inline constexpr std::uint16_t kMavlinkCrcStart = 0xFFFF;

// CRC-16/MCRF4XX, which MAVLink calls X.25: polynomial 0x1021, reflected, start 0xFFFF, nothing
// inverted at the end. Over `123456789` 0x6F91. `crc` continues an earlier call.
std::uint16_t mavlinkCrc(std::span<const std::uint8_t> bytes, std::uint16_t crc = kMavlinkCrcStart);

}  // namespace hedr
