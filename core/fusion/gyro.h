#pragma once

#include "core/fusion/dead_reckoning.h"
#include "core/robot/motion.h"

namespace hedr {

// Distance from the wheels, heading from the gyro with the bias that was measured at the start.
class GyroEstimator {
  public:
    explicit GyroEstimator(const Pose<World>& start) : pose_(start) {}

    void update(const Motion& motion) {
        pose_ = advanced(pose_, motion.distance_m, motion.gyro_turn_rad.value_or(0.0));
        bias_rad_s_ = motion.gyro_bias_rad_s;
    }
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return bias_rad_s_; }

  private:
    Pose<World> pose_;
    double bias_rad_s_ = 0.0;
};

}  // namespace hedr
