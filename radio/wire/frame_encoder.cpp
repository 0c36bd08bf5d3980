#include "radio/wire/frame_encoder.h"

#include <algorithm>
#include <cassert>

#include "radio/wire/byte_order.h"
#include "radio/wire/cobs.h"
#include "radio/wire/crc32c.h"

namespace hedr {
namespace {

FrameBytes encodeAt(std::size_t start, const Frame& frame) {
    assert(frame.payload.size() <= kMaxPayloadBytes);
    const auto payload = frame.payload.first(std::min(frame.payload.size(), kMaxPayloadBytes));
    FrameBytes result;
    const auto block = std::span(result.bytes).subspan(start, kMinBlockBytes + payload.size());
    block[1] = frame.id;
    storeLittle(frame.sequence, &block[2]);
    std::copy(payload.begin(), payload.end(), block.begin() + 1 + kFrameHeaderBytes);
    const auto checked = block.subspan(1, kFrameHeaderBytes + payload.size());
    storeLittle(crc32c(checked), &block[1 + checked.size()]);
    cobsEncodeInPlace(block);
    result.size = start + block.size() + 1;
    return result;
}

}  // namespace

FrameBytes encodeFrame(const Frame& frame) { return encodeAt(0, frame); }

FrameBytes encodeFrameAfterSilence(const Frame& frame) { return encodeAt(1, frame); }

}  // namespace hedr
