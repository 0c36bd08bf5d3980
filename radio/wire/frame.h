#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hedr {

// The number of the protocol, as hello says it.
inline constexpr int kProtocol = 1;

// On the line: COBS( id u8, sequence u16, payload, CRC-32C u32 ), 0x00. See radio/README.md.
inline constexpr std::size_t kMaxPayloadBytes = 200;
inline constexpr std::size_t kFrameHeaderBytes = 3;
inline constexpr std::size_t kChecksumBytes = 4;
// One COBS code byte in front: all bytes of a frame up to its 0x00.
inline constexpr std::size_t kMinBlockBytes = 1 + kFrameHeaderBytes + kChecksumBytes;
inline constexpr std::size_t kMaxBlockBytes = kMinBlockBytes + kMaxPayloadBytes;

struct Frame {
    std::uint8_t id = 0;
    std::uint16_t sequence = 0;
    std::span<const std::uint8_t> payload{};
};

// The frame of one message as it goes on the line.
struct FrameBytes {
    std::array<std::uint8_t, kMaxBlockBytes + 2> bytes{};  // 0x00 at the end, perhaps in front too
    std::size_t size = 0;

    std::span<const std::uint8_t> view() const { return std::span(bytes).first(size); }
};

}  // namespace hedr
