#pragma once

#include <cmath>

#include "core/fusion/dead_reckoning.h"
#include "core/geometry/angle.h"
#include "core/robot/motion.h"

namespace hedr {

struct GyrodometryConfig {
    // 0.125 degrees per 0.1 s in the paper, kept as a rate so that it does not depend on sampling.
    double threshold_rad_s = radFromDeg(1.25);
};

// Borenstein and Feng, "Gyrodometry", ICRA 1996: odometry, except while it differs from the gyro by
// more than a threshold, as it does when a wheel climbs over a bump.
class Gyrodometry {
  public:
    Gyrodometry(const Pose<World>& start, const GyrodometryConfig& config)
        : config_(config), pose_(start) {}

    void update(const Motion& motion) {
        pose_ = advanced(pose_, motion.distance_m, turn(motion));
        bias_rad_s_ = motion.gyro_bias_rad_s;
    }
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return bias_rad_s_; }

  private:
    double turn(const Motion& motion) const {
        if (!motion.gyro_turn_rad) return motion.odometry_turn_rad.value_or(0.0);
        if (!motion.odometry_turn_rad) return *motion.gyro_turn_rad;
        // Eq. (1) to (3). Differs from the paper: its Eq. (3) multiplies an angle by T once more.
        const double difference_rad = *motion.gyro_turn_rad - *motion.odometry_turn_rad;
        const bool slipping = std::abs(difference_rad) > config_.threshold_rad_s * motion.dt_s;
        return slipping ? *motion.gyro_turn_rad : *motion.odometry_turn_rad;
    }

    GyrodometryConfig config_;
    Pose<World> pose_;
    double bias_rad_s_ = 0.0;
};

}  // namespace hedr
