#pragma once

#include <cstdint>

#include "core/site/plan.h"

namespace hedr {

// Pictures without a dominant direction, 1200 x 1200 px.
enum class Aimless {
    kRings,
    kSpiral,
    kCurves,
    kRoundBuilding,
    kText,
    kFields,
    kStarOfWalls,
    kNoise
};

PlanImage aimlessSheet(Aimless kind, std::uint64_t seed);

// Some straight lines of one direction and its right angle among lines at random, with noise.
struct MixedSheet {
    PlanImage plan;
    double direction_rad = 0.0;
    bool aimless = false;  // none of the lines has the direction
};

MixedSheet mixedSheet(std::uint64_t seed);

}  // namespace hedr
