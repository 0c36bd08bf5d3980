#include "core/fusion/compass.h"

#include <cmath>

#include "core/geometry/angle.h"
#include "core/robot/level_field.h"

namespace hedr {

std::optional<double> Compass::heading(const Motion& motion, double believed_rad) {
    moved_ = moved_ || motion.distance_m != 0.0 || motion.odometry_turn_rad.value_or(0.0) != 0.0;
    if (!motion.magnetic_field) return std::nullopt;
    const LevelField field = withoutIron(*motion.magnetic_field, range_);
    const bool has_direction = std::isfinite(field.ahead) && std::isfinite(field.left) &&
                               (field.ahead != 0.0 || field.left != 0.0);
    if (!has_direction) return std::nullopt;
    // Eq. (7). Differs from the paper: all four quadrants, with the signs of x ahead and y left.
    const double from_north_rad = field.heading_rad();
    if (!moved_ || north_ == Vector<World>{}) {
        const double north_rad = (moved_ ? believed_rad : start_heading_rad_) - from_north_rad;
        north_ = north_ + Vector<World>{std::cos(north_rad), std::sin(north_rad)};
    }
    return wrapAngle(std::atan2(north_.y, north_.x) + from_north_rad);
}

}  // namespace hedr
