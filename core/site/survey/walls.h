#pragma once

#include <span>

#include "core/result.h"
#include "core/site/free_space.h"
#include "core/site/plan.h"
#include "core/site/wall_stroke.h"

namespace hedr {

// Finds walls and free space from a plan's pixels: line drawings (walls solid, or hollow between
// two lines; dark on light or light on dark), scans, photos of paper, and maps made by robots,
// whose own greys count. Text, furniture and the thin lines of doors are passed over, so that doors
// are open; what lies outside a closed building is unknown. An image that is no drawing (an aerial
// photo) is unknown as a whole. README.md says how. At most 4 million cells.
// Errors: kCanceled, kNoData (a plan without pixels).
Result<FreeSpace> freeSpaceOf(const PlanImage& plan, const PlanProgress& progress = {});

// Paints what an operator has drawn, in order, onto the free space of a plan of that height.
FreeSpace withStrokes(FreeSpace space, const PlanPlacement& placement, int height_px,
                      std::span<const WallStroke> strokes);

}  // namespace hedr
