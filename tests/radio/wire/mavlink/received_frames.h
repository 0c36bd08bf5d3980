#pragma once

#include <algorithm>
#include <vector>

#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/mavlink/mavlink_decoder.h"

namespace hedr::test {

using Bytes = std::vector<std::uint8_t>;

inline void append(Bytes& to, std::span<const std::uint8_t> more) {
    to.insert(to.end(), more.begin(), more.end());
}

struct Received {
    std::vector<std::uint32_t> times_ms;  // of the attitudes
    std::vector<std::uint32_t> ids;
    WireCounters counters;
    std::uint64_t signed_frames = 0;
    friend bool operator==(const Received&, const Received&) = default;
};

inline Received receive(std::span<const std::uint8_t> bytes, std::size_t piece = 1U << 20) {
    Received got;
    MavlinkDecoder decoder;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
        decoder.feed(bytes.subspan(at, std::min(piece, bytes.size() - at)),
                     [&](const MavlinkFrame& frame) {
                         got.ids.push_back(frame.message_id);
                         if (frame.message_id != MavlinkAttitude::kId) return;
                         const auto m = readMavlink<MavlinkAttitude>(frame.payload);
                         got.times_ms.push_back(m.time_boot_ms);
                     });
    }
    got.counters = decoder.counters();
    got.signed_frames = decoder.signedFrames();
    return got;
}

inline Bytes attitude(unsigned number, int version = 2) {
    const MavlinkAttitude m{.time_boot_ms = number, .yaw = 1.5F, .yawspeed = -0.25F};
    const MavlinkBytes bytes = encodeMavlink(m, {.version = version,
                                                 .sequence = static_cast<std::uint8_t>(number),
                                                 .system = 1,
                                                 .component = 1});
    return {bytes.view().begin(), bytes.view().end()};
}

// A whole frame of an id that nobody here knows; its checksum is anything.
inline Bytes unknown(std::uint8_t sequence, std::uint8_t length = 20) {
    Bytes bytes{kMavlinkMagic2, length, 0, 0, sequence, 1, 1, 24, 0, 0};
    for (int i = 0; i < length + 2; ++i) bytes.push_back(static_cast<std::uint8_t>(100 + i % 50));
    return bytes;
}

}  // namespace hedr::test
