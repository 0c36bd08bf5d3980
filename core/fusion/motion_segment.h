#pragma once

#include <cmath>

#include "core/geometry/frames.h"

namespace hedr {

// Motions of one piece of the way, summed up once so that many hypotheses can be moved by it at the
// cost of one (preintegration). The frame is the robot's at the beginning of the piece.
struct MotionSegment {
    // One motion: the turn by the heading sensor, by what is believed now, and by the encoders.
    struct Step {
        double dt_s = 0.0;
        double distance_m = 0.0;
        bool silent = false;  // the heading sensor's; the wheels speak for it
        double sensed_rad = 0.0;
        double believed_rad = 0.0;
        double witness_rad = 0.0;
    };

    double dt_s = 0.0;
    double heard_s = 0.0;  // of the heading sensor; its bias acts so long
    double unheard_swing_rad = 0.0;
    double distance_m = 0.0;       // signed
    double path_m = 0.0;           // not signed
    double sensed_turn_rad = 0.0;  // of the heading sensor, bias included
    double turn_rad = 0.0;         // the same less the bias that is believed now
    double swing_rad = 0.0;        // the sum of the turns' sizes
    double witness_turn_rad = 0.0;
    Vector<Robot> displacement{};

    void add(const Step& step) {
        const double middle = turn_rad + 0.5 * step.believed_rad;
        displacement = displacement + Vector<Robot>{step.distance_m * std::cos(middle),
                                                    step.distance_m * std::sin(middle)};
        dt_s += step.dt_s;
        if (!step.silent) heard_s += step.dt_s;
        if (step.silent) unheard_swing_rad += std::abs(step.believed_rad);
        distance_m += step.distance_m;
        path_m += std::abs(step.distance_m);
        sensed_turn_rad += step.sensed_rad;
        turn_rad += step.believed_rad;
        swing_rad += std::abs(step.believed_rad);
        witness_turn_rad += step.witness_rad;
    }
};

}  // namespace hedr
