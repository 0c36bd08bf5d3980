#pragma once

#include "core/fusion/dead_reckoning.h"
#include "core/fusion/pose_covariance.h"
#include "core/fusion/sensor_noise.h"
#include "core/robot/motion.h"

namespace hedr {

// Distance from the wheels, heading from the gyro with the bias that was measured at the start.
class GyroEstimator {
  public:
    GyroEstimator(const Pose<World>& start, const WheelNoise& wheels, const GyroNoise& gyro)
        : wheels_(wheels), gyro_(gyro), pose_(start), covariance_(gyro.bias_rad2_s2()) {}

    void update(const Motion& motion) {
        const double turn_rad = motion.gyro_turn_rad.value_or(0.0);
        const Point<World> before = pose_.position;
        pose_ = advanced(pose_, motion.distance_m, turn_rad);
        bias_rad_s_ = motion.gyro_bias_rad_s;
        covariance_.move(pose_.position - before,
                         {.along_m2 = wheels_.along_m2(motion.distance_m, 0.0),
                          .turn_rad2 = gyro_.turn_rad2(motion.dt_s, turn_rad),
                          .drift_share = motion.dt_s,
                          .drift_variance = gyro_.biasWalk_rad2_s2(motion.dt_s)});
    }
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return bias_rad_s_; }
    Eigen::Matrix3d covariance() const { return covariance_.matrix(); }

  private:
    WheelNoise wheels_;
    GyroNoise gyro_;
    Pose<World> pose_;
    PoseCovariance covariance_;
    double bias_rad_s_ = 0.0;
};

}  // namespace hedr
