#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/robot/vehicle.h"

namespace hedr {

// How far wheels are off: each wheel's travel, independently, by an error that grows with the root
// of its way.
struct WheelNoise {
    double wheelbase_m = 0.4;
    double slip_sqrtm = 0.03;  // m per sqrt(m)

    // Variances that one step adds.
    double along_m2(double distance_m, double turn_rad) const {
        return 0.25 * squaredSlip() * wayOfBothWheels_m(distance_m, turn_rad);
    }
    double turn_rad2(double distance_m, double turn_rad) const {
        return squaredSlip() * wayOfBothWheels_m(distance_m, turn_rad) /
               (wheelbase_m * wheelbase_m);
    }

  private:
    double squaredSlip() const { return slip_sqrtm * slip_sqrtm; }
    double wayOfBothWheels_m(double distance_m, double turn_rad) const {
        return std::max(2.0 * std::abs(distance_m), wheelbase_m * std::abs(turn_rad));
    }
};

// How far a gyro is off: white noise of the rate, a bias that is not known well and walks, and a
// scale that is off differently from turn to turn.
struct GyroNoise {
    double rate_rad_s_sqrthz = radFromDeg(0.05);
    double bias_rad_s = radFromDeg(0.02);  // what a standing start leaves of it
    double bias_walk_rad_s_sqrts = radFromDeg(0.006);
    double scale_rad_sqrtrad = radFromDeg(2.0);

    double turn_rad2(double dt_s, double turn_rad) const {
        return rate_rad_s_sqrthz * rate_rad_s_sqrthz * dt_s +
               scale_rad_sqrtrad * scale_rad_sqrtrad * std::abs(turn_rad);
    }
    double bias_rad2_s2() const { return bias_rad_s * bias_rad_s; }
    double biasWalk_rad2_s2(double dt_s) const {
        return bias_walk_rad_s_sqrts * bias_walk_rad_s_sqrts * dt_s;
    }
};

// How far a magnetic heading is off indoors: iron in walls and floors turns it, here more, there
// less.
struct MagneticNoise {
    double disturbance_rad = radFromDeg(10.0);
    double disturbance_m = 2.0;  // the way over which it changes

    // The share of the heading's error that is left after some way.
    double kept(double distance_m) const { return std::exp(-std::abs(distance_m) / disturbance_m); }
    double turn_rad2(double kept) const {
        return disturbance_rad * disturbance_rad * (1.0 - kept * kept);
    }
};

inline WheelNoise wheelNoiseOf(const Vehicle& vehicle) {
    return {.wheelbase_m = vehicle.geometry.wheelbase_m};
}

// What the vehicle file says, and the defaults where it says nothing.
inline GyroNoise gyroNoiseOf(const Vehicle& vehicle) {
    GyroNoise noise;
    if (vehicle.gyro_noise_rad_s_sqrthz > 0.0)
        noise.rate_rad_s_sqrthz = vehicle.gyro_noise_rad_s_sqrthz;
    if (vehicle.gyro_bias_walk_rad_s_sqrts > 0.0)
        noise.bias_walk_rad_s_sqrts = vehicle.gyro_bias_walk_rad_s_sqrts;
    return noise;
}

}  // namespace hedr
