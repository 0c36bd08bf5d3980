#pragma once

#include "core/fusion/dead_reckoning.h"
#include "core/fusion/pose_covariance.h"
#include "core/fusion/sensor_noise.h"
#include "core/robot/motion.h"

namespace hedr {

// Wheels only: heading from the difference of the two encoders.
class OdometryEstimator {
  public:
    OdometryEstimator(const Pose<World>& start, const WheelNoise& noise)
        : noise_(noise), pose_(start) {}

    void update(const Motion& motion) {
        const double turn_rad = motion.odometry_turn_rad.value_or(0.0);
        const Point<World> before = pose_.position;
        pose_ = advanced(pose_, motion.distance_m, turn_rad);
        covariance_.move(pose_.position - before,
                         {.along_m2 = noise_.along_m2(motion.distance_m, turn_rad),
                          .turn_rad2 = noise_.turn_rad2(motion.distance_m, turn_rad)});
    }
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return 0.0; }
    Eigen::Matrix3d covariance() const { return covariance_.matrix(); }

  private:
    WheelNoise noise_;
    Pose<World> pose_;
    PoseCovariance covariance_{};
};

}  // namespace hedr
