#include "core/fusion/dominant_direction.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kMemory_m = 5.0;        // older pieces fade, so that a crooked start is forgotten
constexpr double kEnough_m = 3.0;        // of straight driving, in all that is remembered
constexpr double kConcentration = 0.95;  // of the mean resultant: 1 is one direction only

}  // namespace

DominantDirection::DominantDirection(double interval_rad, std::optional<double> known_rad)
    : interval_rad_(interval_rad),
      known_(known_rad.has_value()),
      direction_rad_(known_rad.value_or(0.0)) {}

void DominantDirection::observe(double heading_rad, double distance_m) {
    if (known_ || distance_m == 0.0) return;
    const double length_m = std::abs(distance_m);
    const double keep = std::exp(-length_m / kMemory_m);
    const double folded_rad = 2.0 * kPi * heading_rad / interval_rad_;
    sum_m_ = keep * sum_m_ + std::polar(length_m, folded_rad);
    weight_m_ = keep * weight_m_ + length_m;
    if (weight_m_ < kEnough_m || std::abs(sum_m_) < kConcentration * weight_m_) return;
    direction_rad_ = std::arg(sum_m_) * interval_rad_ / (2.0 * kPi);
    known_ = true;
}

double DominantDirection::deviation_rad(double heading_rad) const {
    return deviationFromGrid(heading_rad - direction_rad_, interval_rad_);
}

}  // namespace hedr
