#include "core/robot/wheel_motion.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

// The counters' difference, the short way round a counter of `bits`.
double countsBetween(std::int64_t before, std::int64_t now, int bits) {
    const auto counts = static_cast<std::int64_t>(static_cast<std::uint64_t>(now) -
                                                  static_cast<std::uint64_t>(before));
    return std::remainder(static_cast<double>(counts), std::ldexp(1.0, bits));
}

WheelMotion differential(double left_m, double right_m, double wheelbase_m) {
    return {0.5 * (left_m + right_m), (right_m - left_m) / wheelbase_m};
}

WheelMotion between(const WheelTicks& old, const WheelTicks& now, const Vehicle& vehicle) {
    const VehicleGeometry& geometry = vehicle.geometry;
    const int bits = vehicle.encoder_counter_bits;
    const double circumference_per_diameter = kPi / geometry.ticks_per_revolution;
    return differential(circumference_per_diameter * geometry.left_wheel_diameter_m *
                            countsBetween(old.left, now.left, bits),
                        circumference_per_diameter * geometry.right_wheel_diameter_m *
                            countsBetween(old.right, now.right, bits),
                        geometry.wheelbase_m);
}

WheelMotion between(const WheelTravel& old, const WheelTravel& now, const Vehicle& vehicle) {
    return differential(now.left_m - old.left_m, now.right_m - old.right_m,
                        vehicle.geometry.wheelbase_m);
}

WheelMotion between(const PathTravel& old, const PathTravel& now, const Vehicle&) {
    return {now.distance_m - old.distance_m, std::nullopt};
}

WheelMotion between(const OdometryPose& old, const OdometryPose& now, const Vehicle&) {
    const double turn = wrapAngle(now.heading_rad - old.heading_rad);
    const double middle = old.heading_rad + 0.5 * turn;
    return {std::cos(middle) * (now.x_m - old.x_m) + std::sin(middle) * (now.y_m - old.y_m), turn};
}

WheelMotion between(std::monostate, std::monostate, const Vehicle&) { return {}; }

}  // namespace

WheelMotion wheelMotionBetween(const Odometry& before, const Odometry& now,
                               const Vehicle& vehicle) {
    if (before.index() != now.index()) return {};
    return std::visit(
        [&](const auto& known) {
            return between(std::get<std::decay_t<decltype(known)>>(before), known, vehicle);
        },
        now);
}

}  // namespace hedr
