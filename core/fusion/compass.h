#pragma once

#include <optional>

#include "core/robot/motion.h"

namespace hedr {

// The heading that a magnetometer gives, in [-pi, pi]. Where it points at the start counts as the
// start's heading, averaged until the wheels first move.
class Compass {
  public:
    Compass(double start_heading_rad, const MagnetometerRange& range)
        : start_heading_rad_(start_heading_rad), range_(range) {}

    // None where the motion brings no usable field. `believed_rad` is the heading after the motion
    // by other sensors, for a field that is first seen on the way.
    std::optional<double> heading(const Motion& motion, double believed_rad);

  private:
    double start_heading_rad_;
    MagnetometerRange range_;
    bool moved_ = false;
    Vector<World> north_{};  // sum of what was seen at the start
};

}  // namespace hedr
