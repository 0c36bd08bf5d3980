#pragma once

#include <cmath>

#include "core/geometry/frames.h"

namespace hedr {

// Motions of one piece of the way, summed up once so that many hypotheses can be moved by it at the
// cost of one (preintegration). The frame is the robot's at the beginning of the piece.
struct MotionSegment {
    double dt_s = 0.0;
    double distance_m = 0.0;       // signed
    double path_m = 0.0;           // not signed
    double sensed_turn_rad = 0.0;  // of the heading sensor, bias included
    double turn_rad = 0.0;         // the same less the bias that is believed now
    double swing_rad = 0.0;        // the sum of the turns' sizes
    Vector<Robot> displacement{};

    void add(double motion_dt_s, double motion_distance_m, double sensed_rad, double believed_rad) {
        const double middle = turn_rad + 0.5 * believed_rad;
        displacement = displacement + Vector<Robot>{motion_distance_m * std::cos(middle),
                                                    motion_distance_m * std::sin(middle)};
        dt_s += motion_dt_s;
        distance_m += motion_distance_m;
        path_m += std::abs(motion_distance_m);
        sensed_turn_rad += sensed_rad;
        turn_rad += believed_rad;
        swing_rad += std::abs(believed_rad);
    }
};

}  // namespace hedr
