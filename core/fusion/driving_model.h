#pragma once

#include "core/geometry/angle.h"

namespace hedr {

// How the robot, its heading sensor and its driver behave. One set per kind of heading sensor.
struct DrivingModel {
    bool turn_from_encoders = false;
    double turn_noise_rad_sqrts = radFromDeg(0.05);  // angle random walk
    double turn_noise_rad_sqrtm = 0.0;               // the same per way, for encoders
    double turn_noise_rad_sqrtrad = 0.0;             // the same per turn, for encoders
    double bias_rad_s = radFromDeg(1.0);             // how large it may be at the start
    double calibrated_bias_rad_s = 0.0;              // else so large; 0: no other guess
    double bias_walk_rad_s_sqrts = radFromDeg(0.004);
    double worse_walk = 1.0;                    // 1: known; else the walk may be so much larger
    double scale = 0.005;                       // share of a turn
    double curvature_rad_m = 0.0;               // turn per way of unequal wheels
    double curvature_walk_rad_m_sqrtm = 0.0;    // and how it changes
    double slip_sqrtm = 0.03;                   // m of way per sqrt(m)
    double zigzag_rad = radFromDeg(2.0);        // rms of a driver's snaking
    double zigzag_m = 0.4;                      // its correlation length
    double lateral_m = 0.15;                    // rms, off the middle of a corridor
    double wander_rad_sqrtm = radFromDeg(0.3);  // how a way along no corridor bends
    double bend_rad_sqrtm = radFromDeg(1.2);    // if it is none straight on
    double bent_share = 0.1;                    // and how often that is
    double crooked_corridor_rad = radFromDeg(0.15);  // of a corridor against the building

    // The encoders' turn beside a gyro's.
    double witness_noise_rad_sqrts = radFromDeg(1.0);  // until it has been observed
    double witness_slip = 0.05;                        // share of a turn, at random
    double unheard_share = 0.1;  // of a turn that only they saw, for want of the gyro
    double witness_scale = 0.1;  // of the wheelbase
    double witness_curvature_rad_m = radFromDeg(0.3);
};

}  // namespace hedr
