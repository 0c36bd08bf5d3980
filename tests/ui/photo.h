#pragma once

#include "core/site/plan.h"
#include "core/site/quad.h"

namespace hedr::test {

// The sample plan on a sheet of paper on a dark table, seen by a phone from the side: 1200 x 900
// px, at the origin, 5 cm per pixel.
PlanImage photographedPlan();
Quad sheetInPhoto();
// Where the photo shows a place of the sample floor.
Point<Plan> inPhoto(Point<World> on_floor);
inline constexpr double kSheetAspect = 1600.0 / 980.0;

}  // namespace hedr::test
