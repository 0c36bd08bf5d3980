#pragma once

#include "core/site/plan.h"

namespace hedr {

// A picture as it is meant to be seen. `exif_orientation` is 1 (as it is) to 8, from the Exif
// standard's table of tag 0x0112; other numbers are taken as 1. A level without pixels gets its
// size only.
PlanLevel oriented(PlanLevel level, int exif_orientation);

}  // namespace hedr
