#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/geometry/frames.h"
#include "core/site/survey/clearance_map.h"
#include "core/site/survey/trail_samples.h"

namespace hedr {

// How a trail lies on a plan.
struct TrailPose {
    Point<PlanGround> middle{};
    double rotation_rad = 0.0;
    double score = 0.0;  // the mean of drivingScore() along it

    // From the trail's middle to a place on the plan.
    Transform<PlanGround, World> groundFromTrail() const;
};

void sortByScore(std::vector<TrailPose>& poses);

// Those of `sorted` that are farther off than that from all better ones, at most so many.
std::vector<TrailPose> distinct(const std::vector<TrailPose>& sorted, double distance_m,
                                double angle_rad, std::size_t most);

}  // namespace hedr
