#pragma once

#include <cmath>

#include "core/geometry/frames.h"

namespace hedr {

// The pose after an arc of constant curvature: exact for straight lines and arcs.
inline Pose<World> advanced(const Pose<World>& pose, double distance_m, double turn_rad) {
    const double half = 0.5 * turn_rad;
    const double chord_per_arc =
        std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
    const double direction = pose.heading_rad + half;
    const double chord_m = distance_m * chord_per_arc;
    return {{pose.position.x + chord_m * std::cos(direction),
             pose.position.y + chord_m * std::sin(direction)},
            pose.heading_rad + turn_rad};
}

}  // namespace hedr
