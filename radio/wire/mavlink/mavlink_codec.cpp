#include "radio/wire/mavlink/mavlink_codec.h"

#include <algorithm>
#include <cassert>

#include "radio/wire/mavlink/mavlink_crc.h"

namespace hedr {
namespace {

// Version 2 leaves zeros at the end out, but for the first byte.
std::size_t lengthWithoutZeros(std::span<const std::uint8_t> payload) {
    std::size_t length = payload.size();
    while (length > 1 && payload[length - 1] == 0) --length;
    return length;
}

void pushHeader(MavlinkBytes& bytes, const MavlinkFrame& frame, std::size_t length) {
    const bool is_v1 = frame.version == 1;
    bytes.push(is_v1 ? kMavlinkMagic1 : kMavlinkMagic2);
    bytes.push(static_cast<std::uint8_t>(length));
    if (!is_v1) {
        bytes.push(0);
        bytes.push(0);
    }
    bytes.push(frame.sequence);
    bytes.push(frame.system);
    bytes.push(frame.component);
    for (unsigned shift = 0; shift < (is_v1 ? 8U : 24U); shift += 8) {
        bytes.push(static_cast<std::uint8_t>(frame.message_id >> shift));
    }
}

}  // namespace

MavlinkBytes encodeMavlinkFrame(const MavlinkFrame& frame) {
    const MavlinkMessageInfo* info = findMavlinkMessage(frame.message_id);
    assert(info != nullptr && (frame.version != 1 || frame.message_id < 256));
    const std::size_t length = frame.version == 1
                                   ? std::min<std::size_t>(frame.payload.size(), info->min_length)
                                   : lengthWithoutZeros(frame.payload);
    MavlinkBytes bytes;
    pushHeader(bytes, frame, length);
    for (const std::uint8_t byte : frame.payload.first(length)) bytes.push(byte);
    const std::uint16_t crc =
        mavlinkCrc({&info->crc_extra, 1}, mavlinkCrc(bytes.view().subspan(1)));
    bytes.push(static_cast<std::uint8_t>(crc));
    bytes.push(static_cast<std::uint8_t>(crc >> 8));
    return bytes;
}

}  // namespace hedr
