#include <algorithm>
#include <utility>

#include "ui/format.h"
#include "ui/map/map_view.h"
#include "ui/map/qt_geometry.h"
#include "ui/map/trail_layer.h"
#include "ui/trail_style.h"

// What the map view draws of the robots; its state and input are in map_view.cpp.
namespace hedr {
namespace {

bool hasEarlierPrimary(const LiveModel& model, const LiveTrail& trail) {
    const LiveTrail* primary = model.primary();
    return primary && trail.name == primary->name;
}

}  // namespace

std::size_t MapView::tailPoints() const {
    std::size_t points = 0;
    for (const auto& [robot, trail] : drawnTrails()) {
        const DrawnTrail* drawn = keeper_.base().find(robot->id, trail->name);
        points += trail->track.size() - (drawn ? drawn->end.points : 0);
    }
    return points;
}

MapScene MapView::sceneOf(std::vector<MapPlan> plans, std::size_t floor) const {
    MapScene scene{std::move(plans), {}, theme_, earlierTrails(floor)};
    for (const MapTrail& shown : trailsOn(floor)) {
        scene.trails.push_back({*shown.trail, penOf(shown), shown.robot->id});
    }
    return scene;
}

std::vector<SceneTrail> MapView::earlierTrails(std::size_t floor) const {
    std::vector<SceneTrail> earlier;
    const auto add = [&](const FleetRobot& robot, bool primary) {
        for (const LeftTrails& left : robot.model.left()) {
            if (left.floor != floor) continue;
            for (const LiveTrail& trail : left.trails) {
                if (!robot.model.isShown(trail)) continue;
                if (hasEarlierPrimary(robot.model, trail) != primary) continue;
                const QPen pen = trailPen(trail.name, primary, inColourOf(robot.mark, theme_));
                earlier.push_back({trail, pen, robot.id});
            }
        }
    };
    for (const FleetRobot& robot : fleet_.robots()) {
        if (&robot != &fleet_.chosen()) add(robot, true);
    }
    add(fleet_.chosen(), false);
    add(fleet_.chosen(), true);
    return earlier;
}

std::vector<MapTrail> MapView::trailsOn(std::size_t floor) const {
    std::vector<MapTrail> drawn;
    const auto add_primary = [&](const FleetRobot& robot) {
        const LiveTrail* primary = robot.model.primary();
        if (primary && robot.model.isShown(*primary)) drawn.push_back({&robot, primary});
    };
    for (const FleetRobot& robot : fleet_.robots()) {
        if (&robot != &fleet_.chosen() && robot.model.floor() == floor) add_primary(robot);
    }
    if (model().floor() != floor) return drawn;
    const auto& trails = model().trails();
    for (std::size_t i = trails.size(); i-- > 0;) {
        if (&trails[i] != model().primary() && model().isShown(trails[i])) {
            drawn.push_back({&fleet_.chosen(), &trails[i]});
        }
    }
    add_primary(fleet_.chosen());
    return drawn;
}

QPen MapView::penOf(const MapTrail& shown) const {
    const auto& [robot, trail] = shown;
    return trailPen(trail->name, trail == robot->model.primary(), inColourOf(robot->mark, theme_));
}

std::optional<RobotSymbol> MapView::symbolOf(const FleetRobot& robot) const {
    const auto pose = robot.model.pose();
    if (!pose || robot.model.floor() != floor_) return std::nullopt;
    constexpr double kLengthPerWheelbase = 1.6;
    const auto& hello = robot.model.last().robot;
    const double wheelbase_m = hello ? hello->geometry.wheelbase_m : 0.0;
    return RobotSymbol{view_.viewFromWorld() * pose->position,
                       pose->heading_rad + view_.rotation_rad,
                       kLengthPerWheelbase * wheelbase_m * view_.pixels_per_metre,
                       robot.model.link(now_).state, robot.mark.shape};
}

QString MapView::labelOf(const FleetRobot& robot) const {
    if (!fleet_.several()) return {};
    const LinkVerdict link = robot.model.link(now_);
    const bool silent = link.state == LinkState::kStale || link.state == LinkState::kLost;
    const QString name = fleet_.callSign(robot);
    return silent ? name + QStringLiteral(" · ") + formatAge(link.age_s) : name;
}

void MapView::nameRobots() {
    std::erase_if(call_signs_, [&](const auto& sign) { return !fleet_.find(sign.first); });
    for (const FleetRobot& robot : fleet_.robots()) call_signs_[robot.id].setText(labelOf(robot));
}

QRectF MapView::callSignRect(const FleetRobot& robot, const RobotSymbol& symbol) const {
    const auto found = call_signs_.find(robot.id);
    return found == call_signs_.end() ? QRectF() : found->second.bounds(symbol);
}

std::optional<RobotId> MapView::robotAt(Point<View> place) const {
    for (const FleetRobot& robot : fleet_.robots()) {
        if (&robot == &fleet_.chosen()) continue;
        const auto symbol = symbolOf(robot);
        if (symbol && (robotBounds(*symbol).contains(toQt(place)) ||
                       callSignRect(robot, *symbol).contains(toQt(place)))) {
            return robot.id;
        }
    }
    return std::nullopt;
}

std::optional<Spread> MapView::spread() const {
    const auto pose = model().pose();
    if (!pose || !showsRobot() || !model().variance().known()) return std::nullopt;
    const Spread spread = spreadOf(model().variance(), pose->position, view_);
    return fitsInto(spread, size()) ? std::optional(spread) : std::nullopt;
}

QRegion MapView::partsOf(const FleetRobot& robot) const {
    const auto symbol = symbolOf(robot);
    if (!symbol) return {};
    QRegion parts = robotBounds(*symbol).toAlignedRect();
    parts += callSignRect(robot, *symbol).toAlignedRect();
    if (!QRectF(rect()).contains(toQt(symbol->position))) {
        parts += edgePointerBounds(*symbol, pointerRect()).toAlignedRect();
    }
    return parts & rect();
}

QRegion MapView::movingParts() const {
    QRegion parts;
    for (const FleetRobot& robot : fleet_.robots()) parts += partsOf(robot);
    if (const auto around = spread()) parts += spreadBounds(*around).toAlignedRect() & rect();
    if (tailPoints() > kMostTailInAFrame) return parts;
    for (const auto& [robot, trail] : drawnTrails()) {
        const DrawnTrail* drawn = keeper_.base().find(robot->id, trail->name);
        if (!drawn) continue;
        parts += trailTailBounds(trail->track, drawn->end.points, view_).toAlignedRect();
    }
    return parts;
}

}  // namespace hedr
