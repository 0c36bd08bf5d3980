#pragma once

#include "core/site/floor_plan.h"
#include "core/site/plan.h"

namespace hedr {

// Draws a floor plan as dark walls on white paper, its rooms lightly tinted and named. The image
// reaches to the outer faces of the outer walls. `floor_origin` is the pose of the floor's drawing.
PlanImage drawFloorPlan(const FloorPlan& floor, double resolution_m,
                        const Pose<World>& floor_origin = {});

}  // namespace hedr
