#pragma once

#include <optional>

#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What the wheels did between two reports.
struct WheelMotion {
    double distance_m = 0.0;           // signed travel of the robot's centre
    std::optional<double> turn_rad{};  // none where the wheels are not told apart
};

// Nothing where the two are of different kinds. Counters wrap at the vehicle's bits.
WheelMotion wheelMotionBetween(const Odometry& before, const Odometry& now, const Vehicle& vehicle);

}  // namespace hedr
