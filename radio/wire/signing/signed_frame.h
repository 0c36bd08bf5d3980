#pragma once

#include "radio/wire/byte_order.h"
#include "radio/wire/frame.h"
#include "radio/wire/signing/siphash.h"

namespace hedr {

// A signed frame is the plain one with a bit in its id, and counter u32 and tag behind its payload.
inline constexpr std::uint8_t kSignedBit = 0x40;
inline constexpr std::uint8_t kFromLaptopBit = 0x80;
inline constexpr std::size_t kCounterBytes = 4;
inline constexpr std::size_t kSignatureBytes = kCounterBytes + std::tuple_size_v<SigningTag>;
inline constexpr std::size_t kMaxSignedPayloadBytes = kMaxPayloadBytes - kSignatureBytes;

constexpr bool isSigned(const Frame& frame) { return (frame.id & kSignedBit) != 0; }

// For signed frames with at least kSignatureBytes of payload.
inline std::uint32_t counterOf(const Frame& frame) {
    return loadLittle<std::uint32_t>(frame.payload.last(kSignatureBytes).data());
}
inline Frame withoutSignature(const Frame& frame) {
    return {.id = static_cast<std::uint8_t>(frame.id & ~kSignedBit),
            .sequence = frame.sequence,
            .payload = frame.payload.first(frame.payload.size() - kSignatureBytes)};
}

// What is signed, in the order of the line: id with its bit, sequence, payload, counter.
// `payload_and_counter` has at most kMaxPayloadBytes.
SigningTag tagOf(const SigningKey& key, const Frame& frame,
                 std::span<const std::uint8_t> payload_and_counter);

}  // namespace hedr
