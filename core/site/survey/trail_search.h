#pragma once

#include <vector>

#include "core/result.h"
#include "core/site/plan.h"
#include "core/site/survey/trail_pose.h"

namespace hedr {

// Every placement of a trail on a plan, in steps of 2 degrees and 0.5 m: the best of them, best
// first. Errors: kCanceled.
Result<std::vector<TrailPose>> searchTrail(const ClearanceMap& map,
                                           const std::vector<TrailSample>& samples,
                                           const PlanProgress& progress);

}  // namespace hedr
