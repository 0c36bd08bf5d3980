#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hedr {

//  version 1: 0xFE length sequence system component id                    payload CRC
//  version 2: 0xFD length incompat compat sequence system component id×3  payload CRC (signature)
inline constexpr std::uint8_t kMavlinkMagic1 = 0xFE;
inline constexpr std::uint8_t kMavlinkMagic2 = 0xFD;
inline constexpr std::size_t kMavlinkHeader1Bytes = 6;
inline constexpr std::size_t kMavlinkHeader2Bytes = 10;
inline constexpr std::size_t kMavlinkChecksumBytes = 2;
inline constexpr std::size_t kMavlinkSignatureBytes = 13;
inline constexpr std::size_t kMaxMavlinkPayloadBytes = 255;
inline constexpr std::size_t kMaxMavlinkFrameBytes =
    kMavlinkHeader2Bytes + kMaxMavlinkPayloadBytes + kMavlinkChecksumBytes + kMavlinkSignatureBytes;
inline constexpr std::uint8_t kMavlinkSignedFlag = 0x01;  // of incompat

struct MavlinkFrame {
    int version = 2;
    bool is_signed = false;  // the signature is not checked
    std::uint8_t sequence = 0;
    std::uint8_t system = 0;
    std::uint8_t component = 0;
    std::uint32_t message_id = 0;
    std::span<const std::uint8_t> payload{};  // as it came: zeros at its end may be missing
};

// A frame as it goes over the line.
class MavlinkBytes {
  public:
    void push(std::uint8_t byte) { bytes_[size_++] = byte; }
    std::span<const std::uint8_t> view() const { return std::span(bytes_).first(size_); }

  private:
    std::array<std::uint8_t, kMaxMavlinkFrameBytes> bytes_{};
    std::size_t size_ = 0;
};

}  // namespace hedr
