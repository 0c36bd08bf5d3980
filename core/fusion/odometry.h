#pragma once

#include "core/fusion/dead_reckoning.h"
#include "core/robot/motion.h"

namespace hedr {

// Wheels only: heading from the difference of the two encoders.
class OdometryEstimator {
  public:
    explicit OdometryEstimator(const Pose<World>& start) : pose_(start) {}

    void update(const Motion& motion) {
        pose_ = advanced(pose_, motion.distance_m, motion.odometry_turn_rad.value_or(0.0));
    }
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return 0.0; }

  private:
    Pose<World> pose_;
};

}  // namespace hedr
