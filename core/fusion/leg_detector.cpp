#include "core/fusion/leg_detector.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kMeanMemory_m = 6.0;

}  // namespace

void LegDetector::restart() {
    heading_rad_ = least_rad_ = most_rad_ = mean_rad_ = 0.0;
    along_m_ = rear_m_ = front_m_ = 0.0;
}

void LegDetector::drive(double distance_m) {
    const double before_m = front_m_ - rear_m_;
    along_m_ += distance_m;
    rear_m_ = std::min(rear_m_, along_m_);
    front_m_ = std::max(front_m_, along_m_);
    new_ground_m_ = front_m_ - rear_m_ - before_m;
}

LegDetector::Change LegDetector::add(const MotionSegment& segment) {
    heading_rad_ += segment.turn_rad;
    least_rad_ = std::min(least_rad_, heading_rad_);
    most_rad_ = std::max(most_rad_, heading_rad_);
    drive(segment.distance_m);
    const double length_m = front_m_ - rear_m_;
    mean_rad_ += (heading_rad_ - mean_rad_) * new_ground_m_ /
                 std::max(std::min(length_m, kMeanMemory_m), 1e-3);
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
    if (length_m < config_.begin_m) return Change::kNone;
    on_leg_ = true;
    return Change::kBegun;
}

}  // namespace hedr
