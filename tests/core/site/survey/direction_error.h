#pragma once

#include <cmath>

#include "core/geometry/angle.h"
#include "core/site/survey/directions.h"

namespace hedr {

// Degrees from the nearest right angle to the truth; NaN where no direction was found.
inline double error_deg(const PlanDirections& directions, double truth_rad) {
    if (!directions.direction_rad) return std::nan("");
    return degFromRad(deviationFromGrid(*directions.direction_rad - truth_rad, kPi / 2));
}

}  // namespace hedr
