#include "ui/site/placement_proposals.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/site/plan_cropping.h"
#include "core/site/survey/directions.h"
#include "core/site/survey/trail_placement.h"
#include "core/site/survey/walls.h"
#include "ui/format.h"
#include "ui/map/miniature.h"

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("PlacementProposals", text); }

QImage pictureOf(const ProposalBasis& basis, const PlanPlacement& placement) {
    MapScene scene = basis.trails;
    scene.plans = {basis.plan};
    scene.plans.front().image.placement = placement;
    return miniatureOf(scene, ChoicesPanel::kPicture, basis.device_ratio);
}

// How far a placement is turned from where the plan lies now.
QString turnOf(const ProposalBasis& basis, const PlanPlacement& placement) {
    const double turn_rad =
        wrapAngle(placement.origin.heading_rad - basis.plan.image.placement.origin.heading_rad);
    constexpr double kUnseen_rad = 1e-4;
    if (std::abs(turn_rad) < kUnseen_rad) return tr("as it is");
    return (turn_rad > 0.0 ? tr("%1 left") : tr("%1 right")).arg(formatAngle(std::abs(turn_rad)));
}

// The newest stretch of the primary trail, oldest point first; what is longer places it no better.
std::vector<Point<World>> primaryTrail(const MapScene& scene) {
    constexpr double kSpacing_m = 0.05;
    constexpr std::size_t kMostPoints = 20'000;
    std::vector<Point<World>> trail;
    if (scene.trails.empty()) return trail;
    const Track& track = scene.trails.back().trail.track;
    for (std::size_t i = track.size(); i-- > 0 && trail.size() < kMostPoints;) {
        const Point<World> at = track.at(i).pose.position;
        if (trail.empty() || (trail.back() - at).length() >= kSpacing_m) trail.push_back(at);
    }
    std::ranges::reverse(trail);
    return trail;
}

// The part of the plan that is shown.
struct ShownPart {
    PlanPart part{};
    PlanImage image{};
};

Result<ShownPart> shownPart(const MapPlan& plan) {
    const PlanLevel& size = plan.image.levels.front();
    const PlanPart part =
        plan.crop ? partOf(*plan.crop, size) : PlanPart{0, 0, size.width_px, size.height_px};
    return shownPlan(plan.image, plan.crop).map([&](const PlanImage& image) {
        return ShownPart{part, image};
    });
}

Result<TrailPlacements> placedByTrail(const ProposalBasis& basis, const PlanImage& shown,
                                      const PlanProgress& progress) {
    constexpr double kShareOfWalls = 0.2;  // of the time
    const int height_px = shown.levels.front().height_px;
    auto space = freeSpaceOf(shown, [&](double share) { return progress(kShareOfWalls * share); });
    if (!space) return tl::make_unexpected(space.error());
    const FreeSpace drawn =
        withStrokes(*std::move(space), shown.placement, height_px, basis.wall_strokes);
    return placeByTrail(
        drawn, shown.placement, height_px, primaryTrail(basis.trails),
        [&](double share) { return progress(kShareOfWalls + (1.0 - kShareOfWalls) * share); });
}

QString directionVerdict(const PlanDirections& found) {
    if (!found.direction_rad) {
        return tr(
            "This plan has no dominant direction: its lines run every way. Turn it by hand, "
            "or set points.");
    }
    return tr("Its walls run at %1 on the image (%2 % sure). Which way does it lie?")
        .arg(formatAngle(*found.direction_rad))
        .arg(qRound(100.0 * found.confidence));
}

}  // namespace

Result<PlacementProposals> proposeTurns(const ProposalBasis& basis, const PlanProgress& progress) {
    const PlanImage& image = basis.plan.image;
    const PlanLevel& size = image.levels.front();
    const auto shown = shownPart(basis.plan);
    if (!shown) return tl::make_unexpected(shown.error());
    const auto found = findDirections(shown->image, progress);
    if (!found) return tl::make_unexpected(found.error());
    PlacementProposals proposals{.verdict = directionVerdict(*found)};
    if (!found->direction_rad) return proposals;
    for (const PlanPlacement& placement : placementsAlong(
             image.placement, size.width_px, size.height_px, *found, basis.direction_rad)) {
        proposals.placements.push_back(placement);
        proposals.choices.push_back({pictureOf(basis, placement), turnOf(basis, placement)});
    }
    return proposals;
}

Result<PlacementProposals> proposeByTrail(const ProposalBasis& basis,
                                          const PlanProgress& progress) {
    const auto shown = shownPart(basis.plan);
    if (!shown) return tl::make_unexpected(shown.error());
    const auto found = placedByTrail(basis, shown->image, progress);
    if (!found && found.error().code == ErrorCode::kNoData) {
        return PlacementProposals{
            .verdict = tr("The trail does not place this plan: %1. Give the plan its scale first "
                          "(Distance), or drive on and open Trail again.")
                           .arg(QString::fromStdString(found.error().detail))};
    }
    if (!found) return tl::make_unexpected(found.error());
    const int height_px = basis.plan.image.levels.front().height_px;
    PlacementProposals proposals{
        .verdict =
            found->ambiguous
                ? tr("Ambiguous: the trail fits in several places about equally well. Choose "
                     "by what you know, or drive on and open Trail again.")
                : tr("The trail fits best in the first one.")};
    for (const TrailPlacement& place : found->best) {
        const PlanPlacement placement = placementOfWhole(place.placement, shown->part, height_px);
        proposals.placements.push_back(placement);
        const QString score = tr("fits %1 %").arg(qRound(100.0 * std::max(0.0, place.score)));
        proposals.choices.push_back({pictureOf(basis, placement), score});
    }
    return proposals;
}

}  // namespace hedr
