#pragma once

#include <array>
#include <optional>

#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// The direction that most of a plan's lines keep, or are at right angles to.
struct PlanDirections {
    // Counter-clockwise from the picture's right as it is seen, in [0, pi/2); none where the lines
    // have no direction in common, as in a round building.
    std::optional<double> direction_rad;
    // 0..1: how sure it is that the direction is right to 0.5 degrees, or, without a direction, how
    // sure the best candidate would have been. README.md says how it was calibrated.
    double confidence = 0.0;
    double sigma_rad = 0.0;  // standard deviation of direction_rad
    double share = 0.0;      // of the lines' length lies along the direction or across it
};

// Errors: kCanceled, kNoData (a plan without pixels).
Result<PlanDirections> findDirections(const PlanImage& plan, const PlanProgress& progress = {});

// The plan turned about its middle so that its direction lies along the world's, in the four ways
// that are possible, the nearest to the present placement first. Without a direction it stays as it
// is and is only turned by right angles.
std::array<PlanPlacement, 4> placementsAlong(const PlanPlacement& placement, int width_px,
                                             int height_px, const PlanDirections& directions,
                                             double world_direction_rad);

}  // namespace hedr
