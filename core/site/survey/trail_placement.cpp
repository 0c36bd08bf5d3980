#include "core/site/survey/trail_placement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "core/geometry/angle.h"
#include "core/site/survey/clearance_map.h"
#include "core/site/survey/trail_fit.h"
#include "core/site/survey/trail_pose.h"
#include "core/site/survey/trail_samples.h"
#include "core/site/survey/trail_search.h"

namespace hedr {
namespace {

// One refinement: so many of the distinct poses, on about so many samples.
struct Stage {
    std::size_t poses = 0;
    double apart_m = 0.0;
    std::size_t samples = 0;
    TrailFit fit{};
    double share_done = 0.0;  // of the work, after it
};
constexpr double kShareOfSearch = 0.6;
constexpr Stage kRough{
    60, 1.5, 150, {.first_step_m = 0.5, .last_step_m = 0.1, .softness_m = 0.7}, 0.8};
constexpr Stage kFine{12, 0.7, 500, {}, 1.0};
constexpr double kApart_rad = radFromDeg(3.0);

constexpr std::size_t kMost = 4;  // a building may be the same after half a turn, and so its halves
constexpr double kDistinct_m = 1.0;
constexpr double kDistinct_rad = radFromDeg(5.0);
// How far the best score must lead to be sure: the more, the worse the trail fits.
double leadToBeSure(double best) { return 0.07 + 0.15 * (1.0 - best); }
constexpr double kFitsNowhere = 0.1;
constexpr double kLargestPlan_m = 1e5;
constexpr double kHalfTurnCosts = 0.1;  // of a score, where several are as good

Result<void> check(const FreeSpace& space, const PlanPlacement& now) {
    const double side_m =
        now.resolution_m * space.plan_px_per_cell * std::max(space.width, space.height);
    if (!(now.resolution_m > 0.0) || !(side_m < kLargestPlan_m)) {
        return fail(ErrorCode::kBadValue, "plan",
                    "its resolution is " + std::to_string(now.resolution_m) +
                        " m, must be more than 0 and leave the plan smaller than 100 km");
    }
    if (std::ranges::find(space.cells, Cell::kFree) == space.cells.end()) {
        return fail(ErrorCode::kNoData, "plan", "it has no free space that a robot could drive in");
    }
    return {};
}

Result<std::vector<TrailPose>> refined(const Stage& stage, const std::vector<TrailPose>& found,
                                       const ClearanceMap& map,
                                       const std::vector<TrailSample>& samples,
                                       const PlanProgress& progress) {
    std::vector<TrailPose> poses = distinct(found, stage.apart_m, kApart_rad, stage.poses);
    const std::vector<TrailSample> some = thinned(samples, stage.samples);
    for (TrailPose& pose : poses) {
        if (progress && !progress(stage.share_done)) return fail(ErrorCode::kCanceled, "trail");
        pose = fitTrail(map, some, pose, stage.fit);
    }
    sortByScore(poses);
    return poses;
}

PlanPlacement placementOf(const TrailPose& pose, Point<World> trail_middle,
                          const PlanPlacement& now, int height_px) {
    const Point<PlanGround> corner{0.0, -height_px * now.resolution_m};
    const Vector<World> from_middle = pose.groundFromTrail().inverse() * (corner - pose.middle);
    return {now.resolution_m, {trail_middle + from_middle, wrapAngle(-pose.rotation_rad)}};
}

// Plans are seldom upside down: of those that fit as well as the best, the less turned come first.
void orderByTurn(std::vector<TrailPlacement>& best, std::size_t as_good, double now_rad) {
    const auto rank = [&](const TrailPlacement& each) {
        const double turn = std::abs(wrapAngle(each.placement.origin.heading_rad - now_rad));
        return each.score - kHalfTurnCosts * turn / kPi;
    };
    std::ranges::stable_sort(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(as_good),
                             std::greater{}, rank);
}

TrailPlacements placementsOf(const std::vector<TrailPose>& poses, Point<World> trail_middle,
                             const PlanPlacement& now, int height_px) {
    TrailPlacements result;
    const double as_good = poses.front().score - leadToBeSure(poses.front().score);
    for (const TrailPose& pose : distinct(poses, kDistinct_m, kDistinct_rad, kMost)) {
        result.best.push_back(
            {placementOf(pose, trail_middle, now, height_px), std::max(0.0, pose.score)});
    }
    const auto rivals = std::ranges::count_if(
        result.best, [&](const TrailPlacement& each) { return each.score >= as_good; });
    result.ambiguous = rivals > 1;
    orderByTurn(result.best, static_cast<std::size_t>(rivals), now.origin.heading_rad);
    return result;
}

}  // namespace

Result<TrailPlacements> placeByTrail(const FreeSpace& space, const PlanPlacement& now,
                                     int height_px, std::span<const Point<World>> trail,
                                     const PlanProgress& progress) {
    if (const auto good = check(space, now); !good) return tl::make_unexpected(good.error());
    const auto sampled = sampleTrail(trail);
    if (!sampled) return tl::make_unexpected(sampled.error());
    const std::vector<TrailSample>& samples = sampled->samples;
    const ClearanceMap map(space, now.resolution_m);
    PlanProgress searching;
    if (progress) searching = [&](double share) { return progress(kShareOfSearch * share); };
    return searchTrail(map, samples, searching)
        .and_then([&](const auto& found) { return refined(kRough, found, map, samples, progress); })
        .and_then([&](const auto& found) { return refined(kFine, found, map, samples, progress); })
        .and_then([&](std::vector<TrailPose> found) -> Result<TrailPlacements> {
            if (found.empty() || found.front().score < kFitsNowhere) {
                return fail(ErrorCode::kNoData, "trail",
                            "it fits nowhere on this plan; perhaps the plan's scale is wrong");
            }
            return placementsOf(found, sampled->middle, now, height_px);
        });
}

}  // namespace hedr
