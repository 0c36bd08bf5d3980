#pragma once

#include "core/site/survey/clearance_map.h"

namespace hedr {

// How well it fits that a robot drove through `place` along `direction` (a unit vector): 1 in the
// middle of a corridor and along it, less at its sides (`softness_m`: the standard deviation), 0
// where there is nothing to steer by, -0.7 where nothing is known, -2 in a wall.
double drivingScore(const ClearanceMap& map, Point<PlanGround> place, Vector<PlanGround> direction,
                    double softness_m);

inline constexpr double kScoreBesidePlan = -0.7;

}  // namespace hedr
