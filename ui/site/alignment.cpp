#include "ui/site/alignment.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "core/site/control_points_file.h"
#include "core/site/geo_text.h"
#include "core/site/placement_moves.h"

namespace hedr {
namespace {

Point<Plan> planPoint(const Alignment& alignment, Point<World> at, int height_px) {
    return worldFromPlan(alignment.placement, height_px).inverse() * at;
}

Result<std::vector<ControlPoint>> inWorld(const ControlPoints& given,
                                          const std::optional<GeoTie>& tie,
                                          const std::string& file) {
    if (const auto* metric = std::get_if<std::vector<ControlPoint>>(&given)) return *metric;
    if (!tie) return fail(ErrorCode::kNoData, file, "the map is not tied to the globe");
    std::vector<ControlPoint> points;
    for (const GeoControlPoint& point : std::get<std::vector<GeoControlPoint>>(given)) {
        const auto world = worldPointOf(point.at, *tie);
        if (!world) return tl::make_unexpected(world.error());
        points.push_back({point.name, point.plan, *world});
    }
    return points;
}

}  // namespace

AlignmentFit fitOf(const Alignment& alignment, int height_px) {
    if (alignment.points.size() < 2) return {};
    FitOptions options;
    if (alignment.keep_scale) options.fixed_resolution_m = alignment.placement.resolution_m;
    if (alignment.keep_rotation) {
        options.fixed_heading_rad = alignment.placement.origin.heading_rad;
    }
    auto fit = fitPlacement(alignment.points, height_px, options);
    if (!fit) return {std::nullopt, fit.error()};
    return {*std::move(fit), std::nullopt};
}

Alignment fitted(Alignment alignment, int height_px) {
    if (alignment.points.size() == 1) {
        const ControlPoint& only = alignment.points.front();
        const Point<World> drawn = worldFromPlan(alignment.placement, height_px) * only.plan;
        alignment.placement = movedBy(alignment.placement, only.world - drawn);
    }
    const AlignmentFit found = fitOf(alignment, height_px);
    if (found.fit) alignment.placement = found.fit->placement;
    return alignment;
}

PlacingPoints placingPointsOf(const Alignment& alignment, int height_px) {
    constexpr double kRounding_m = 1e-6;
    const AlignmentFit found = fitOf(alignment, height_px);
    if (!found.fit) return {};
    const auto as_they_say = worldFromPlan(found.fit->placement, height_px);
    const auto as_it_lies = worldFromPlan(alignment.placement, height_px);
    const auto agrees = [&](const ControlPoint& point) {
        return (as_they_say * point.plan - as_it_lies * point.plan).length() < kRounding_m;
    };
    if (!std::ranges::all_of(alignment.points, agrees)) return {};
    return {alignment.points, alignment.keep_scale, alignment.keep_rotation};
}

Alignment withClick(Alignment alignment, Point<World> at, int height_px) {
    if (!alignment.waiting) {
        alignment.waiting = planPoint(alignment, at, height_px);
        return alignment;
    }
    alignment.points.push_back({{}, *alignment.waiting, at});
    alignment.waiting.reset();
    return fitted(std::move(alignment), height_px);
}

Result<Alignment> withTypedPlace(Alignment alignment, std::string_view text,
                                 const std::optional<GeoTie>& tie, int height_px) {
    return worldPointFromText(text, tie).map(
        [&](Point<World> at) { return withClick(std::move(alignment), at, height_px); });
}

Result<Alignment> withPointsOf(const std::filesystem::path& file, Alignment alignment,
                               const std::optional<GeoTie>& tie, int height_px) {
    const auto loaded = loadControlPoints(file);
    if (!loaded) return tl::make_unexpected(loaded.error());
    const auto points = inWorld(*loaded, tie, file.string());
    if (!points) return tl::make_unexpected(points.error());
    alignment.points = *points;
    alignment.waiting.reset();
    return fitted(std::move(alignment), height_px);
}

Alignment withoutPoint(Alignment alignment, std::size_t point, int height_px) {
    alignment.points.erase(alignment.points.begin() + static_cast<std::ptrdiff_t>(point));
    return fitted(std::move(alignment), height_px);
}

Alignment withRulerClick(Alignment alignment, Point<World> at, int height_px) {
    if (alignment.ruler.size() >= 2) alignment.ruler.clear();
    alignment.ruler.push_back(planPoint(alignment, at, height_px));
    alignment.distance_m.reset();
    return alignment;
}

Result<Alignment> withDistance(Alignment alignment, double distance_m, int height_px) {
    const auto scaled = fitTwoPointsAndDistance(alignment.ruler.at(0), alignment.ruler.at(1),
                                                distance_m, height_px, alignment.placement);
    if (!scaled) return tl::make_unexpected(scaled.error());
    alignment.placement = *scaled;
    alignment.distance_m = distance_m;
    alignment.points.clear();  // they said another scale
    return alignment;
}

}  // namespace hedr
