#include "core/fusion/compass.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

std::optional<double> Compass::heading(const Motion& motion, double believed_rad) {
    moved_ = moved_ || motion.distance_m != 0.0 || motion.odometry_turn_rad.value_or(0.0) != 0.0;
    if (!motion.magnetic_field) return std::nullopt;
    const double ahead = (motion.magnetic_field->x - range_.centre_x) / range_.range_x;
    const double left = (motion.magnetic_field->y - range_.centre_y) / range_.range_y;
    if (!std::isfinite(ahead) || !std::isfinite(left) || (ahead == 0.0 && left == 0.0))
        return std::nullopt;
    // Eq. (7). Differs from the paper: all four quadrants, with the signs of x ahead and y left.
    const double from_north_rad = std::atan2(-left, ahead);
    if (!moved_ || north_ == Vector<World>{}) {
        const double north_rad = (moved_ ? believed_rad : start_heading_rad_) - from_north_rad;
        north_ = north_ + Vector<World>{std::cos(north_rad), std::sin(north_rad)};
    }
    return wrapAngle(std::atan2(north_.y, north_.x) + from_north_rad);
}

}  // namespace hedr
