#pragma once

#include <vector>

#include "core/site/survey/trail_pose.h"

namespace hedr {

struct TrailFit {
    double first_step_m = 0.3;
    double last_step_m = 0.01;
    double softness_m = 0.5;
    double most_scaling = 0.0;  // as a share
};

// The best pose near `pose`: steps along each axis (turning and scaling as far as they move the
// trail's parts on average), halved where none of them gets better.
TrailPose fitTrail(const ClearanceMap& map, const std::vector<TrailSample>& samples, TrailPose pose,
                   const TrailFit& fit);

}  // namespace hedr
