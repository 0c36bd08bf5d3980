#include <algorithm>
#include <utility>

#include "ui/map/map_view.h"
#include "ui/map/qt_geometry.h"
#include "ui/map/trail_layer.h"
#include "ui/trail_style.h"

// What the map view draws of the model; its state and input are in map_view.cpp.
namespace hedr {

std::size_t MapView::tailPoints() const {
    std::size_t points = 0;
    for (const LiveTrail* trail : drawnTrails()) {
        const DrawnTrail* drawn = keeper_.base().find(trail->name);
        points += trail->track.size() - (drawn ? drawn->end.points : 0);
    }
    return points;
}

MapScene MapView::sceneOf(std::vector<MapPlan> plans, std::size_t floor) const {
    MapScene scene{std::move(plans), {}, theme_, earlierTrails(floor)};
    if (floor != model_.floor()) return scene;
    for (const LiveTrail* trail : chosenTrails()) scene.trails.push_back({*trail, penOf(*trail)});
    return scene;
}

std::vector<SceneTrail> MapView::earlierTrails(std::size_t floor) const {
    std::vector<SceneTrail> earlier;
    const LiveTrail* primary = model_.primary();
    for (const LeftTrails& left : model_.left()) {
        if (left.floor != floor) continue;
        const auto is_primary = [&](const LiveTrail& trail) {
            return primary && trail.name == primary->name;
        };
        for (const bool first : {false, true}) {
            for (const LiveTrail& trail : left.trails) {
                if (!model_.isShown(trail) || is_primary(trail) != first) continue;
                earlier.push_back({trail, trailPen(trail.name, first, theme_)});
            }
        }
    }
    return earlier;
}

std::vector<const LiveTrail*> MapView::chosenTrails() const {
    std::vector<const LiveTrail*> drawn;
    const auto& trails = model_.trails();
    const LiveTrail* primary = model_.primary();
    for (std::size_t i = trails.size(); i-- > 0;) {
        if (&trails[i] != primary && model_.isShown(trails[i])) drawn.push_back(&trails[i]);
    }
    if (primary && model_.isShown(*primary)) drawn.push_back(primary);
    return drawn;
}

std::vector<const LiveTrail*> MapView::drawnTrails() const {
    return showsRobot() ? chosenTrails() : std::vector<const LiveTrail*>{};
}

QPen MapView::penOf(const LiveTrail& trail) const {
    return trailPen(trail.name, &trail == model_.primary(), theme_);
}

std::optional<RobotSymbol> MapView::robotSymbol() const {
    const auto pose = model_.pose();
    if (!pose || !showsRobot()) return std::nullopt;
    constexpr double kLengthPerWheelbase = 1.6;
    const auto& robot = model_.last().robot;
    const double wheelbase_m = robot ? robot->geometry.wheelbase_m : 0.0;
    return RobotSymbol{view_.viewFromWorld() * pose->position,
                       pose->heading_rad + view_.rotation_rad,
                       kLengthPerWheelbase * wheelbase_m * view_.pixels_per_metre, link_.state};
}

std::optional<Spread> MapView::spread() const {
    const auto pose = model_.pose();
    if (!pose || !showsRobot() || !model_.variance().known()) return std::nullopt;
    const Spread spread = spreadOf(model_.variance(), pose->position, view_);
    return fitsInto(spread, size()) ? std::optional(spread) : std::nullopt;
}

QRegion MapView::movingParts() const {
    QRegion parts;
    if (const auto robot = robotSymbol()) {
        parts += robotBounds(*robot).toAlignedRect();
        if (!QRectF(rect()).contains(toQt(robot->position))) parts += rect();
    }
    if (const auto around = spread()) parts += spreadBounds(*around).toAlignedRect() & rect();
    if (tailPoints() > kMostTailInAFrame) return parts;
    for (const LiveTrail* trail : drawnTrails()) {
        const DrawnTrail* drawn = keeper_.base().find(trail->name);
        if (!drawn) continue;
        parts += trailTailBounds(trail->track, drawn->end.points, view_).toAlignedRect();
    }
    return parts;
}

}  // namespace hedr
