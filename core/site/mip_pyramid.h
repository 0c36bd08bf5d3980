#pragma once

#include <optional>
#include <vector>

#include "core/site/plan.h"

namespace hedr {

// The image and its halves (rounded up), each pixel the mean of those that it covers, until the
// larger side is below 512 px.
std::vector<PlanLevel> mipPyramid(const PlanLevel& full_size);

// The size of the next level, without pixels; nothing where a level is small enough.
std::optional<PlanLevel> halfOf(const PlanLevel& level);

// A part of a level that is in memory, each pixel the mean of what it covers.
PlanLevel areaAveraged(const PlanLevel& level, const PlanPart& part, int width_px, int height_px);

// The picture by area averaging, at most `side_px` wide and high; the levels must be in memory.
PlanLevel fittedInto(const std::vector<PlanLevel>& levels, int side_px);

}  // namespace hedr
