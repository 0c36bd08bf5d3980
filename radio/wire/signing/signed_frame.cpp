#include "radio/wire/signing/signed_frame.h"

#include <algorithm>
#include <cassert>

namespace hedr {

SigningTag tagOf(const SigningKey& key, const Frame& frame,
                 std::span<const std::uint8_t> payload_and_counter) {
    assert(payload_and_counter.size() <= kMaxPayloadBytes);
    std::array<std::uint8_t, kFrameHeaderBytes + kMaxPayloadBytes> bytes{};
    bytes[0] = frame.id;
    storeLittle(frame.sequence, &bytes[1]);
    std::ranges::copy(payload_and_counter, bytes.begin() + kFrameHeaderBytes);
    return sipHash(key, std::span(bytes).first(kFrameHeaderBytes + payload_and_counter.size()));
}

}  // namespace hedr
