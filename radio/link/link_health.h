#pragma once

#include <cstdint>

namespace hedr {

// Counters of one link, since it was opened. Plain numbers: they cross threads by value.
struct LinkHealth {
    std::uint64_t bytes = 0;
    std::uint64_t good_frames = 0;
    std::uint64_t bad_frames = 0;      // wrong checksum, length or COBS code
    std::uint64_t lost_frames = 0;     // gaps in the sequence numbers
    std::uint64_t late_frames = 0;     // overtaken or repeated, and not used
    std::uint64_t unknown_frames = 0;  // good, but of an id that this version does not know
    std::uint64_t restarts = 0;        // of the robot
    std::uint64_t reconnects = 0;      // of the port

    // Share of frames sent that did not arrive whole, 0..1.
    double lossRatio() const {
        const double sent = static_cast<double>(good_frames + lost_frames);
        return sent > 0.0 ? static_cast<double>(lost_frames) / sent : 0.0;
    }

    friend bool operator==(const LinkHealth&, const LinkHealth&) = default;
};

}  // namespace hedr
