#pragma once

#include <optional>

#include "core/fusion/dominant_direction.h"
#include "core/fusion/estimate.h"
#include "core/geometry/angle.h"
#include "core/robot/motion.h"

namespace hedr {

struct HedrConfig {
    HeadingSource heading_source = HeadingSource::kGyro;
    double interval_rad = radFromDeg(45.0);     // between dominant directions: 90 or 45 degrees
    double compliant_rad = radFromDeg(12.0);    // farther off them is a way of its own
    double gain_rad_s2 = radFromDeg(0.01);      // k = i_c / T of the paper
    double damping_rad_s = radFromDeg(0.1);     // rate of the part that acts on the heading itself
    double leak_s = 20.0;                       // I falls back to its own running mean
    double drift_window_s = 60.0;               // of that running mean, which is shown as drift
    double hold_s = 120.0;                      // without evidence for so long, I is dropped
    double turn_rate_rad_s = radFromDeg(10.0);  // faster than this is a turn
    double direction_settled_m = 20.0;          // of straight driving, to find the building's axes
    std::optional<double> direction_rad{};      // heading of one corridor; none: learnt
};

// A preset per kind of heading sensor. The drift of encoders is larger and changes faster than a
// gyro's, so they need a larger gain, a shorter memory, and every way as a hint: what is far off
// the directions may be drift.
HedrConfig hedrPreset(HeadingSource source);

// Borenstein, Borrell, Miller, Thomas, "Heuristics-Enhanced Dead-Reckoning", SPIE 2010: an
// integrator I, driven by the sign of the deviation from the nearest dominant direction of the
// building, cancels the drift of the yaw rate.
class Hedr {
  public:
    Hedr(const Pose<World>& start, const HedrConfig& config);

    void update(const Motion& motion);
    // The heading of one corridor, from a plan; none: learnt from here on.
    void setDirection(std::optional<double> direction_rad);
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return standing_bias_rad_s_ + status_.drift_rad_s; }
    const HedrStatus& status() const { return status_; }

  private:
    void judge(const Motion& motion, double turn_rad);
    void learn(double dt_s);
    void age(double dt_s);
    void watchLock(double distance_m);

    HedrConfig config_;
    Pose<World> pose_;
    DominantDirection direction_;
    HedrStatus status_{};
    double correction_rad_s_ = 0.0;  // I
    double rate_rad_s_ = 0.0;        // low-passed, for the turn test
    double standing_bias_rad_s_ = 0.0;
    double off_rad_ = 0.0;  // mean deviation from the nearest dominant direction
};

}  // namespace hedr
