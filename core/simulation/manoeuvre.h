#pragma once

#include <span>
#include <vector>

#include "core/geometry/frames.h"

namespace hedr {

// A straight way, an arc or a turn on the spot, begun and ended at rest; or a pause.
struct Manoeuvre {
    double distance_m = 0.0;  // negative: backward
    double turn_rad = 0.0;
    double pause_s = 0.0;  // where it neither drives nor turns
};

struct Pace {
    double speed_m_s = 1.0;
    double turn_rate_rad_s = 1.0;
    double ramp_s = 0.5;  // to come to speed, and to stop
};

// What happens between two samples.
struct MotionStep {
    double distance_m = 0.0;
    double turn_rad = 0.0;
};

// The manoeuvres one after the other, each an entire number of samples long.
std::vector<MotionStep> stepsOf(std::span<const Manoeuvre> manoeuvres, const Pace& pace,
                                double rate_hz);

// The pose after a step that is short enough to have one direction.
Pose<World> after(const Pose<World>& pose, const MotionStep& step);

}  // namespace hedr
