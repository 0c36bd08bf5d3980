#pragma once

#include <optional>

namespace hedr {

// How the link was over about one second.
struct LinkSample {
    double receive_time_s = 0.0;  // its end; seconds since the mission's start
    double loss = 0.0;            // share of the frames sent that did not come, 0..1
    double frames_per_s = 0.0;    // good ones
    double bad_frames_per_s = 0.0;
    double longest_gap_s = 0.0;  // without a good frame, also one that is not over yet
    double jitter_s = 0.0;       // of the time on the way, as RFC 3550 smooths it
    std::optional<double> round_trip_s{};
    std::optional<double> clock_offset_s{};  // the robot's clock less ours
    std::optional<int> radio_dbm{};
    friend bool operator==(const LinkSample&, const LinkSample&) = default;
};

}  // namespace hedr
