#pragma once

#include <vector>

#include "core/site/plan.h"

namespace hedr {

// The image and its halves (rounded up), each pixel the mean of those that it covers, until the
// larger side is below 512 px.
std::vector<PlanLevel> mipPyramid(const PlanLevel& full_size);

}  // namespace hedr
