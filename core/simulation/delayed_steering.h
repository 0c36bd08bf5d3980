#pragma once

#include <deque>

#include "core/simulation/random.h"

namespace hedr {

// A human who steers straight by a camera whose pictures come late: he turns in proportion to the
// course error that he sees, as hard as the delay allows, and his hand is not steady (the crossover
// model of McRuer and Jex, "A Review of Quasi-Linear Pilot Models", 1967). The snaking comes from
// the delay; nothing else is added to the course.
class DelayedSteering {
  public:
    // Snakes by `zigzag_rad` (rms times sqrt 2), whatever the delay.
    DelayedSteering(double zigzag_rad, double step_s);

    // The pictures are so old from now on.
    void setVideoLag(double lag_s);
    // He knows what his own turns do; after one he looks anew.
    void lookAnew() { seen_rad_.clear(); }
    // Once per step: the yaw rate that he commands.
    double yawRate_rad_s(double course_error_rad, Random& random);

  private:
    double zigzag_rad_;
    double step_s_;
    std::size_t delay_steps_ = 0;
    double gain_1_s_ = 0.0;
    double hand_rad_s_ = 0.0;  // rms
    CorrelatedNoise hand_;
    std::deque<double> seen_rad_;
};

}  // namespace hedr
