#include "tests/core/site/survey/judged_placement.h"

#include <functional>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

Vector<World> meanOf(const std::vector<Point<World>>& points) {
    Vector<World> sum{};
    for (const Point<World>& point : points) sum = sum + (point - Point<World>{});
    return (1.0 / static_cast<double>(points.size())) * sum;
}

// Least squares of the estimate on the truth, rotation and shift.
Pose<World> estimateInTruth(const DriveOnPlan& drive) {
    const Vector<World> from_middle = meanOf(drive.estimate);
    const Vector<World> to_middle = meanOf(drive.truth);
    double along = 0.0;
    double across = 0.0;
    for (std::size_t i = 0; i < drive.truth.size(); ++i) {
        const Vector<World> from = drive.estimate[i] - (Point<World>{} + from_middle);
        const Vector<World> to = drive.truth[i] - (Point<World>{} + to_middle);
        along += from.x * to.x + from.y * to.y;
        across += from.x * to.y - from.y * to.x;
    }
    const double turn_rad = std::atan2(across, along);
    const auto turned = rigidTransform<World, World>({{}, turn_rad}) * from_middle;
    return {Point<World>{} + to_middle + (-1.0) * turned, turn_rad};
}

}  // namespace

double trueTurn_rad(const DriveOnPlan& drive) {
    return drive.plan.placement.origin.heading_rad - estimateInTruth(drive).heading_rad;
}

Judgement judged(const PlanPlacement& found, const DriveOnPlan& drive) {
    const PlanLevel& image = drive.plan.levels.front();
    const auto estimate_from_plan = worldFromPlan(found, image.height_px);
    const auto truth_from_plan = drive.plan.worldFromPlan();
    const auto to_truth = rigidTransform<World, World>(estimateInTruth(drive));

    Judgement result;
    double sum = 0.0;
    for (std::size_t i = 0; i < drive.truth.size(); ++i) {
        const Point<Plan> placed = estimate_from_plan.inverse() * drive.estimate[i];
        sum += std::pow((truth_from_plan * placed - drive.truth[i]).length(), 2);
    }
    result.trail_m = std::sqrt(sum / static_cast<double>(drive.truth.size()));
    const Point<Plan> middle{0.5 * image.width_px, 0.5 * image.height_px};
    const Point<World> placed_middle = to_truth * (estimate_from_plan * middle);
    result.middle_m = (placed_middle - truth_from_plan * middle).length();
    result.rotation_deg =
        std::abs(degFromRad(wrapAngle(found.origin.heading_rad - trueTurn_rad(drive))));
    return result;
}

std::optional<std::size_t> rankOfTrue(const TrailPlacements& found, const DriveOnPlan& drive,
                                      double distance_m, double angle_deg) {
    for (std::size_t i = 0; i < found.best.size(); ++i) {
        if (judged(found.best[i].placement, drive).within(distance_m, angle_deg)) return i;
    }
    return std::nullopt;
}

DriveOnPlan driveOn(const PlanImage& plan, const std::vector<TrackPoint>& track,
                    const std::vector<TrackPoint>& truth) {
    DriveOnPlan drive{.plan = plan};
    for (const TrackPoint& point : track) {
        const auto after =
            std::ranges::lower_bound(truth, point.t_s, std::less{}, &TrackPoint::t_s);
        if (after == truth.begin() || after == truth.end()) continue;
        const TrackPoint& before = *(after - 1);
        const double share = (point.t_s - before.t_s) / (after->t_s - before.t_s);
        drive.estimate.push_back(point.pose.position);
        drive.truth.push_back(before.pose.position +
                              share * (after->pose.position - before.pose.position));
    }
    return drive;
}

}  // namespace hedr
