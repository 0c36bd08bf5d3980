#pragma once

#include "core/geometry/frames.h"
#include "ui/map/view_transform.h"

namespace hedr {

// The least move of the map, in whole pixels, that keeps the robot and some way ahead of it within
// the free middle of the view. A map that need not move stays still.
ViewTransform followed(const ViewTransform& view, const Pose<World>& robot,
                       const ViewMargins& margins);

}  // namespace hedr
