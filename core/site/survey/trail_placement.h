#pragma once

#include <span>
#include <vector>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/free_space.h"
#include "core/site/plan.h"

namespace hedr {

struct TrailPlacement {
    PlanPlacement placement{};
    double score = 0.0;  // 1: all of the trail runs along the middle of corridors; 0: it fits badly
};

struct TrailPlacements {
    std::vector<TrailPlacement> best{};  // 1 to 4 that differ by more than 1 m or 5 degrees
    bool ambiguous = false;              // the second fits about as well as the first
};

// Where a plan may lie, so that the trail (oldest first) stays in its free space and runs along its
// corridors. Nothing need be known but the plan's scale, which is kept. Best first; of those that
// fit about equally well, as in a building that looks the same after half a turn, the less turned
// from `now`. Errors: kBadValue (the trail or the scale is not a number), kNoData (a trail shorter
// than 20 m or without a turn, a plan without free space, no place that fits), kCanceled.
Result<TrailPlacements> placeByTrail(const FreeSpace& space, const PlanPlacement& now,
                                     int height_px, std::span<const Point<World>> trail,
                                     const PlanProgress& progress = {});

}  // namespace hedr
