#include "core/simulation/manoeuvre.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hedr {

namespace {

double duration_s(const Manoeuvre& manoeuvre, const Pace& pace) {
    const double moving_s = std::max(std::abs(manoeuvre.distance_m) / pace.speed_m_s,
                                     std::abs(manoeuvre.turn_rad) / pace.turn_rate_rad_s);
    return moving_s > 0.0 ? moving_s + pace.ramp_s : manoeuvre.pause_s;
}

// The share of the way that is done after `t` of `total`: speeds up, goes on, slows down.
double progress(double t_s, double total_s, double ramp_s) {
    const double ramp = std::min(ramp_s, 0.5 * total_s);
    const double speed = 1.0 / (total_s - ramp);
    if (t_s < ramp) return 0.5 * speed * t_s * t_s / ramp;
    const double left_s = total_s - t_s;
    if (left_s < ramp) return 1.0 - 0.5 * speed * left_s * left_s / ramp;
    return speed * (t_s - 0.5 * ramp);
}

}  // namespace

std::vector<MotionStep> stepsOf(std::span<const Manoeuvre> manoeuvres, const Pace& pace,
                                double rate_hz) {
    std::vector<MotionStep> steps;
    for (const Manoeuvre& manoeuvre : manoeuvres) {
        const auto samples =
            static_cast<std::size_t>(std::ceil(duration_s(manoeuvre, pace) * rate_hz));
        const double total_s = static_cast<double>(samples) / rate_hz;
        double before = 0.0;
        for (std::size_t i = 1; i <= samples; ++i) {
            const double now = progress(static_cast<double>(i) / rate_hz, total_s, pace.ramp_s);
            steps.push_back(
                {(now - before) * manoeuvre.distance_m, (now - before) * manoeuvre.turn_rad});
            before = now;
        }
    }
    return steps;
}

Pose<World> after(const Pose<World>& pose, const MotionStep& step) {
    const double middle = pose.heading_rad + 0.5 * step.turn_rad;
    return {pose.position + Vector<World>{step.distance_m * std::cos(middle),
                                          step.distance_m * std::sin(middle)},
            pose.heading_rad + step.turn_rad};
}

}  // namespace hedr
