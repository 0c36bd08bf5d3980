#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// A place that is known both on a plan image and in the world.
struct ControlPoint {
    std::string name;
    Point<Plan> plan{};
    Point<World> world{};
    friend bool operator==(const ControlPoint&, const ControlPoint&) = default;
};

struct FitOptions {
    std::optional<double> fixed_resolution_m{};  // metres per pixel
    std::optional<double> fixed_heading_rad{};   // of the plan's x axis in the world
};

// What can be said of the worst point.
enum class Blunder {
    kCannotTell,  // too few points to single one out
    kNone,        // the residuals look like chance
    kUnclear,     // something is wrong, but two points explain it about as well
    kProbable,    // the worst point is probably wrong
};

// One standard deviation of each parameter, 0 where it was fixed.
struct PlacementSigma {
    double resolution_m = 0.0;
    double heading_rad = 0.0;
    Vector<World> origin_m{};
};

struct PlanFit {
    PlanPlacement placement{};
    std::vector<Vector<World>> residuals_m{};  // where the plan puts a point minus where it is
    double rms_m = 0.0;                        // of the residuals' lengths
    std::optional<PlacementSigma> sigma{};     // none without redundancy
    std::optional<std::size_t> worst{};        // the point to check first
    double chance = 1.0;                       // that good points look as bad as the worst does
    Blunder blunder = Blunder::kCannotTell;
    bool all_on_a_line = false;  // a mirrored plan cannot be told: set a point beside the line
};

// The placement of a plan of that height that puts the points where they are, by least squares.
// The worst point is the one whose removal lowers the sum of squares most (Baarda's data snooping,
// with the variance estimated from the other points).
// Errors, kBadValue: fewer than two points, points that coincide, a coordinate that is not a
// number, a fixed value that is no length or angle, points that fit a mirrored plan only.
Result<PlanFit> fitPlacement(std::span<const ControlPoint> points, int plan_height_px,
                             const FitOptions& options = {});

// Scales the plan so that `distance_m` lies between a and b; a stays where `current` puts it, and
// the heading stays. Errors, kBadValue: a and b coincide, no positive distance.
Result<PlanPlacement> fitTwoPointsAndDistance(Point<Plan> a, Point<Plan> b, double distance_m,
                                              int plan_height_px, const PlanPlacement& current);

}  // namespace hedr
