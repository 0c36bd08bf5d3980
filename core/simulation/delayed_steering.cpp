#include "core/simulation/delayed_steering.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kReaction_s = 0.3;
constexpr double kHandTime_s = 0.3;
constexpr double kMostGain_1_s = 2.0;
constexpr double kGainTimesDelay_rad = 0.7;  // leaves a phase margin of 50 degrees

}  // namespace

DelayedSteering::DelayedSteering(double zigzag_rad, double step_s)
    : zigzag_rad_(zigzag_rad), step_s_(step_s), hand_(kHandTime_s, step_s) {}

void DelayedSteering::setVideoLag(double lag_s) {
    const double delay_s = kReaction_s + lag_s;
    delay_steps_ = static_cast<std::size_t>(std::lround(delay_s / step_s_));
    gain_1_s_ = std::min(kMostGain_1_s, kGainTimesDelay_rad / delay_s);
    // The variance of x' = -k x(t - d) + s w is s^2 / 2k (1 + sin kd) / cos kd (Küchler and Mensch,
    // "Langevin's stochastic differential equation extended by a time-delayed term", 1992).
    const double phase = gain_1_s_ * delay_s;
    const double variance = 0.5 * zigzag_rad_ * zigzag_rad_;
    const double s2 = 2.0 * gain_1_s_ * variance * std::cos(phase) / (1.0 + std::sin(phase));
    hand_rad_s_ = std::sqrt(s2 / (2.0 * kHandTime_s));
}

double DelayedSteering::yawRate_rad_s(double course_error_rad, Random& random) {
    seen_rad_.push_back(course_error_rad);
    while (seen_rad_.size() > delay_steps_ + 1) seen_rad_.pop_front();
    return gain_1_s_ * seen_rad_.front() + hand_rad_s_ * hand_.next(random);
}

}  // namespace hedr
