#pragma once

#include <vector>

#include "core/site/plan.h"

namespace hedr {

// Two points near one face of a long straight wall, picked by eye in the picture.
struct PickedWall {
    Point<Plan> from{};
    Point<Plan> to{};
};

// The direction of a robot map's walls, by no means but eye and least squares: the mean of their
// own angles, by the squares of their lengths, without those that are not straight to 1.2 px.
double pickedDirection_rad(const PlanLevel& map, const std::vector<PickedWall>& walls);

}  // namespace hedr
