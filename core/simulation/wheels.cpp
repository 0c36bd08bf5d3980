#include "core/simulation/wheels.h"

#include <cmath>
#include <cstdint>

#include "core/geometry/angle.h"

namespace hedr {

WheelTicks wheelCounts(const VehicleGeometry& wheels, double left_m, double right_m) {
    const double turns_to_ticks = wheels.ticks_per_revolution / kPi;
    const auto counts = [](double ticks) { return static_cast<std::int64_t>(std::floor(ticks)); };
    return {counts(left_m * turns_to_ticks / wheels.left_wheel_diameter_m),
            counts(right_m * turns_to_ticks / wheels.right_wheel_diameter_m)};
}

void Wheels::move(double distance_m, double turn_rad, Random& random) {
    const double half_turn_m = 0.5 * turn_rad * real_.wheelbase_m;
    left_m_ += rolled(distance_m - half_turn_m, random);
    right_m_ += rolled(distance_m + half_turn_m, random);
}

double Wheels::rolled(double way_m, Random& random) const {
    return way_m + unevenness_m_sqrtm_ * std::sqrt(std::abs(way_m)) * random.normal();
}

}  // namespace hedr
