#pragma once

#include <cstdint>
#include <functional>

#include "core/robot/report.h"

namespace hedr {

// What every decoder of a robot's language has in common, whichever it is.

using OnReport = std::function<void(const Report& report)>;

// Since the decoder was made.
struct WireCounters {
    std::uint64_t bytes = 0;
    std::uint64_t good_frames = 0;     // whole and with the right checksum; of text: lines
    std::uint64_t bad_frames = 0;      // wrong checksum, length or form
    std::uint64_t lost_frames = 0;     // gaps in the sequence numbers, where there are any
    std::uint64_t late_frames = 0;     // overtaken by others, or here already: not used
    std::uint64_t unknown_frames = 0;  // good, but not known to this version
    friend bool operator==(const WireCounters&, const WireCounters&) = default;
};

}  // namespace hedr
