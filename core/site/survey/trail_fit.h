#pragma once

#include <vector>

#include "core/site/survey/trail_pose.h"

namespace hedr {

struct TrailFit {
    double first_step_m = 0.3;
    double last_step_m = 0.01;
    double softness_m = 0.5;
};

// The best pose near `pose`: steps along each axis (turning as far as it moves the trail's parts
// on average), halved where none of them gets better.
TrailPose fitTrail(const ClearanceMap& map, const std::vector<TrailSample>& samples, TrailPose pose,
                   const TrailFit& fit);

}  // namespace hedr
