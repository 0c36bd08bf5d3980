#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/site/plan.h"
#include "core/site/survey/trail_placement.h"
#include "core/track/track.h"

namespace hedr {

// A drive on a plan, as an estimator saw it and as it was: estimate and truth of the same times.
struct DriveOnPlan {
    PlanImage plan{};  // placed where it is
    std::vector<Point<World>> estimate{};
    std::vector<Point<World>> truth{};
};

// How the plan is turned where it lies right on the estimate.
double trueTurn_rad(const DriveOnPlan& drive);

struct Judgement {
    double trail_m = 0.0;       // from the trail's places on the plan to the true ones (rms)
    double middle_m = 0.0;      // of the plan's middle, the trail rigidly laid on the truth
    double rotation_deg = 0.0;  // against that

    double position_m() const { return std::max(trail_m, middle_m); }
    bool within(double distance_m, double angle_deg) const {
        return position_m() <= distance_m && rotation_deg <= angle_deg;
    }
};

Judgement judged(const PlanPlacement& found, const DriveOnPlan& drive);

// The first of them that is within; none where there is none.
std::optional<std::size_t> rankOfTrue(const TrailPlacements& found, const DriveOnPlan& drive,
                                      double distance_m, double angle_deg);

// Pairs a track with the truth, which is interpolated; without what is not covered by it.
DriveOnPlan driveOn(const PlanImage& plan, const std::vector<TrackPoint>& track,
                    const std::vector<TrackPoint>& truth);

}  // namespace hedr
