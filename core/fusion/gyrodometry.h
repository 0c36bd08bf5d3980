#pragma once

#include <cmath>

#include "core/fusion/dead_reckoning.h"
#include "core/fusion/pose_covariance.h"
#include "core/fusion/sensor_noise.h"
#include "core/geometry/angle.h"
#include "core/robot/motion.h"

namespace hedr {

struct GyrodometryConfig {
    // 0.125 degrees per 0.1 s in the paper, kept as a rate so that it does not depend on sampling.
    double threshold_rad_s = radFromDeg(1.25);
    WheelNoise wheels{};
    GyroNoise gyro{};
};

// Borenstein and Feng, "Gyrodometry", ICRA 1996: odometry, except while it differs from the gyro by
// more than a threshold, as it does when a wheel climbs over a bump.
class Gyrodometry {
  public:
    Gyrodometry(const Pose<World>& start, const GyrodometryConfig& config)
        : config_(config), pose_(start), covariance_(config.gyro.bias_rad2_s2()) {}

    void update(const Motion& motion) {
        const bool gyro = believesGyro(motion);
        const double turn_rad =
            gyro ? *motion.gyro_turn_rad : motion.odometry_turn_rad.value_or(0.0);
        const Point<World> before = pose_.position;
        pose_ = advanced(pose_, motion.distance_m, turn_rad);
        bias_rad_s_ = motion.gyro_bias_rad_s;
        covariance_.move(pose_.position - before,
                         {.along_m2 = config_.wheels.along_m2(motion.distance_m, turn_rad),
                          .turn_rad2 = gyro ? config_.gyro.turn_rad2(motion.dt_s, turn_rad)
                                            : config_.wheels.turn_rad2(motion.distance_m, turn_rad),
                          .drift_share = gyro ? motion.dt_s : 0.0,
                          .drift_variance = config_.gyro.biasWalk_rad2_s2(motion.dt_s)});
    }
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return bias_rad_s_; }
    Eigen::Matrix3d covariance() const { return covariance_.matrix(); }

  private:
    bool believesGyro(const Motion& motion) const {
        if (!motion.gyro_turn_rad) return false;
        if (!motion.odometry_turn_rad) return true;
        // Eq. (1) to (3). Differs from the paper: its Eq. (3) multiplies an angle by T once more.
        const double difference_rad = *motion.gyro_turn_rad - *motion.odometry_turn_rad;
        return std::abs(difference_rad) > config_.threshold_rad_s * motion.dt_s;
    }

    GyrodometryConfig config_;
    Pose<World> pose_;
    PoseCovariance covariance_;
    double bias_rad_s_ = 0.0;
};

}  // namespace hedr
