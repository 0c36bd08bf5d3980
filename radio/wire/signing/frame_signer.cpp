#include "radio/wire/signing/frame_signer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "radio/wire/frame_decoder.h"
#include "radio/wire/frame_encoder.h"

namespace hedr {

std::optional<FrameBytes> FrameSigner::sign(const FrameBytes& plain) {
    std::optional<FrameBytes> result;
    FrameDecoder().feed(plain.view(), [&](const Frame& frame) {
        constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max() - kBlock;
        if (frame.payload.size() > kMaxSignedPayloadBytes || counter_ >= kLast) {
            return;
        }
        if (counter_ == reserved_) {
            reserved_ += kBlock;
            reserved_changed_ = true;
        }
        ++counter_;
        result = signedFrame(frame, plain.bytes[0] == 0);
    });
    return result;
}

FrameBytes FrameSigner::signedFrame(const Frame& frame, bool after_silence) const {
    std::array<std::uint8_t, kMaxPayloadBytes> bytes{};
    const std::size_t size = frame.payload.size() + kSignatureBytes;
    const Frame result{.id = static_cast<std::uint8_t>(frame.id | kSignedBit),
                       .sequence = frame.sequence,
                       .payload = std::span(bytes).first(size)};
    std::ranges::copy(frame.payload, bytes.begin());
    storeLittle(counter_, &bytes[frame.payload.size()]);
    const std::size_t tag_at = frame.payload.size() + kCounterBytes;
    std::ranges::copy(tagOf(key_, result, std::span(bytes).first(tag_at)), &bytes[tag_at]);
    return after_silence ? encodeFrameAfterSilence(result) : encodeFrame(result);
}

std::optional<std::uint32_t> FrameSigner::takeReserved() {
    return std::exchange(reserved_changed_, false) ? std::optional(reserved_) : std::nullopt;
}

}  // namespace hedr
