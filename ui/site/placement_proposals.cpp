#include "ui/site/placement_proposals.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/site/survey/directions.h"
#include "core/site/survey/trail_placement.h"
#include "core/site/survey/walls.h"
#include "ui/format.h"
#include "ui/map/miniature.h"

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("PlacementProposals", text); }

int heightOf(const ProposalBasis& basis) { return basis.plan.image.levels.front().height_px; }

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
    const auto found = findDirections(image, progress);
    if (!found) return tl::make_unexpected(found.error());
    PlacementProposals proposals{.verdict = directionVerdict(*found)};
    if (!found->direction_rad) return proposals;
    const PlanLevel& size = image.levels.front();
    for (const PlanPlacement& placement : placementsAlong(
             image.placement, size.width_px, size.height_px, *found, basis.direction_rad)) {
        proposals.placements.push_back(placement);
        proposals.choices.push_back({pictureOf(basis, placement), turnOf(basis, placement)});
    }
    return proposals;
}

Result<PlacementProposals> proposeByTrail(const ProposalBasis& basis,
                                          const PlanProgress& progress) {
    constexpr double kShareOfWalls = 0.2;  // of the time
    auto space = freeSpaceOf(basis.plan.image,
                             [&](double share) { return progress(kShareOfWalls * share); });
    if (!space) return tl::make_unexpected(space.error());
    const PlanPlacement& now = basis.plan.image.placement;
    const FreeSpace drawn =
        withStrokes(*std::move(space), now, heightOf(basis), basis.wall_strokes);
    const auto found = placeByTrail(
        drawn, now, heightOf(basis), primaryTrail(basis.trails),
        [&](double share) { return progress(kShareOfWalls + (1.0 - kShareOfWalls) * share); });
    if (!found) return tl::make_unexpected(found.error());
    PlacementProposals proposals{
        .verdict =
            found->ambiguous
                ? tr("Ambiguous: the trail fits in several places about equally well. Choose "
                     "by what you know, or drive on and search again.")
                : tr("The trail fits best in the first one.")};
    for (const TrailPlacement& place : found->best) {
        proposals.placements.push_back(place.placement);
        const QString score = tr("fits %1 %").arg(qRound(100.0 * std::max(0.0, place.score)));
        proposals.choices.push_back({pictureOf(basis, place.placement), score});
    }
    return proposals;
}

}  // namespace hedr
