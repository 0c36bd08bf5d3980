#pragma once

#include <Eigen/Core>
#include <span>

#include "core/fusion/weighted_hypothesis.h"

namespace hedr {

// What all hypotheses say together.
struct Belief {
    Pose<World> pose{};
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // x, y, heading; of the mixture
    double bias_rad_s = 0.0;
    double scale = 0.0;
    double curvature_rad_m = 0.0;
    double share = 1.0;           // weight of those that agree on the pose
    double building_share = 1.0;  // weight of those that believe in a building
    double sigma_rad = 0.0;       // of the heading against the building, if there is one
    LegKind leg = LegKind::kNone;
    bool building = true;  // false: dead reckoning only
};

// The mean of the likeliest hypothesis and of those that lie in the same quarter of directions; the
// covariance is that of the whole mixture about it. `shown` is where the robot was said to be until
// now: another place must be clearly likelier. The weights add up to 1, the span is not empty.
Belief beliefOf(std::span<const WeightedHypothesis> hypotheses, const Pose<World>& shown);

}  // namespace hedr
