#include "core/fusion/dominant_direction.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kStartWeight_m = 5.0;   // the start heading counts like so much straight driving
constexpr double kMemory_m = 10.0;       // contrary pieces fade: a robot also drives round tables
constexpr double kConcentration = 0.9;   // of a mean resultant: 1 is one direction only
constexpr double kAgreeing = 1.0 / 6.0;  // of the interval, to each side

}  // namespace

DominantDirection::DominantDirection(const Config& config)
    : config_(config),
      settled_(config.known_rad.has_value()),
      direction_rad_(config.known_rad.value_or(config.start_heading_rad)) {
    add(agreeing_, direction_rad_, kStartWeight_m);
}

void DominantDirection::observe(double heading_rad, double distance_m) {
    if (settled_ || distance_m == 0.0) return;
    const double length_m = std::abs(distance_m);
    if (trustedAt(heading_rad)) {
        add(agreeing_, heading_rad, length_m);
        direction_rad_ = std::arg(agreeing_.sum_m) * config_.interval_rad / (2.0 * kPi);
        settled_ = agreeing_.weight_m >= config_.settled_m;
        return;
    }
    const double keep = std::exp(-length_m / kMemory_m);
    contrary_ = {keep * contrary_.weight_m, keep * contrary_.sum_m};
    add(contrary_, heading_rad, length_m);
    const bool one_direction = std::abs(contrary_.sum_m) > kConcentration * contrary_.weight_m;
    if (one_direction && contrary_.weight_m > kStartWeight_m) overrule();
}

void DominantDirection::overrule() {
    agreeing_ = contrary_;
    contrary_ = {};
    direction_rad_ = std::arg(agreeing_.sum_m) * config_.interval_rad / (2.0 * kPi);
}

void DominantDirection::add(Evidence& evidence, double heading_rad, double length_m) const {
    evidence.weight_m += length_m;
    evidence.sum_m += std::polar(length_m, 2.0 * kPi * heading_rad / config_.interval_rad);
}

bool DominantDirection::trustedAt(double heading_rad) const {
    return settled_ || std::abs(deviation_rad(heading_rad)) < kAgreeing * config_.interval_rad;
}

double DominantDirection::deviation_rad(double heading_rad) const {
    return deviationFromGrid(heading_rad - direction_rad_, config_.interval_rad);
}

}  // namespace hedr
