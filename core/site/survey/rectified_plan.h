#pragma once

#include "core/site/plan.h"
#include "core/site/site.h"

namespace hedr {

// A photo of a plan, straightened, with its levels, placed where the photo's quad lay.
// Errors: those of rectificationOf, rectified and readWhole.
Result<PlanImage> rectifiedPlan(const PlanImage& photo, const Straightening& straightening,
                                const PlanProgress& progress = {});

}  // namespace hedr
