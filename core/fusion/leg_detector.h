#pragma once

#include <array>
#include <cstddef>

#include "core/fusion/motion_segment.h"
#include "core/geometry/angle.h"

namespace hedr {

// Finds the straight stretches of a way, from turns that a gyro measures well over seconds.
class LegDetector {
  public:
    struct Config {
        double begin_m = 1.8;                     // so far it got in a straight line
        double begin_spread_rad = radFromDeg(8);  // within which the heading stayed meanwhile
        double end_deviation_rad = radFromDeg(14);
        double end_rate_rad_s = radFromDeg(15.0);
    };

    enum class Change { kNone, kBegun, kEnded };

    explicit LegDetector(const Config& config) : config_(config) {}

    Change add(const MotionSegment& segment);
    bool onLeg() const { return on_leg_; }
    // How far the last segment got beyond what had been driven of this stretch. To and fro on one
    // line is one line, which says once where it leads.
    double newGround_m() const { return new_ground_m_; }

  private:
    void restart();
    void drive(double distance_m);

    Config config_;
    bool on_leg_ = false;
    double heading_rad_ = 0.0;  // relative to where the stretch began
    double least_rad_ = 0.0;
    double most_rad_ = 0.0;
    double mean_rad_ = 0.0;
    double along_m_ = 0.0;  // signed
    double rear_m_ = 0.0;
    double front_m_ = 0.0;
    double new_ground_m_ = 0.0;
};

}  // namespace hedr
