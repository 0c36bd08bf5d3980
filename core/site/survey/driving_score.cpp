#include "core/site/survey/driving_score.h"

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

constexpr double kHalfWidth_m = 0.3;  // of a robot
constexpr double kReach_m = 4.0;      // how far off a wall guides an operator
constexpr double kNarrow_m = 3.0;     // a corridor that guides him wholly
constexpr double kWallWeight = 1.3;   // on top of what is lost for not being free

// 0 with room for the robot, 1 with none.
double overlap(double distance_m) { return std::max(0.0, 1.0 - distance_m / kHalfWidth_m); }

double corridorScore(const ClearanceMap& map, Point<PlanGround> place, Vector<PlanGround> direction,
                     double softness_m) {
    const Vector<PlanGround> left{-direction.y, direction.x};
    const double left_m = map.clearance_m(place, left, kReach_m);
    if (left_m >= kReach_m) return 0.0;
    const double right_m = map.clearance_m(place, -1.0 * left, kReach_m);
    if (right_m >= kReach_m) return 0.0;
    const double aside = 0.5 * (left_m - right_m) / softness_m;
    return std::min(1.0, kNarrow_m / (left_m + right_m)) * std::exp(-0.5 * aside * aside);
}

}  // namespace

double drivingScore(const ClearanceMap& map, Point<PlanGround> place, Vector<PlanGround> direction,
                    double softness_m) {
    const double to_unfree_m = map.toUnfree_m(place);
    const double corridor =
        to_unfree_m > 0.0 ? corridorScore(map, place, direction, softness_m) : 0.0;
    return corridor + kScoreBesidePlan * overlap(to_unfree_m) -
           kWallWeight * overlap(map.toWall_m(place));
}

}  // namespace hedr
