#include "core/fusion/leg_detector.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kMeanMemory_m = 6.0;

}  // namespace

void LegDetector::restart() { heading_rad_ = least_rad_ = most_rad_ = mean_rad_ = length_m_ = 0.0; }

LegDetector::Change LegDetector::add(const MotionSegment& segment) {
    heading_rad_ += segment.turn_rad;
    least_rad_ = std::min(least_rad_, heading_rad_);
    most_rad_ = std::max(most_rad_, heading_rad_);
    length_m_ += segment.path_m;
    mean_rad_ += (heading_rad_ - mean_rad_) * segment.path_m /
                 std::max(std::min(length_m_, kMeanMemory_m), 1e-3);
    const bool turning = segment.swing_rad > config_.end_rate_rad_s * segment.dt_s &&
                         std::abs(segment.turn_rad) > 0.5 * segment.swing_rad;
    if (on_leg_) {
        const bool away = std::abs(heading_rad_ - mean_rad_) > config_.end_deviation_rad;
        if (!turning && !away) return Change::kNone;
        on_leg_ = false;
        restart();
        return Change::kEnded;
    }
    if (turning || most_rad_ - least_rad_ > config_.begin_spread_rad) {
        restart();
        return Change::kNone;
    }
    if (length_m_ < config_.begin_m) return Change::kNone;
    on_leg_ = true;
    return Change::kBegun;
}

}  // namespace hedr
