#include "ui/map/base_image.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/map/plan_layer.h"
#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

QPolygonF outline(const PlanCrop& crop, const Transform<View, Plan>& view_from_plan) {
    QPolygonF polygon;
    for (const Point<Plan>& corner :
         {crop.min, {crop.max.x, crop.min.y}, crop.max, {crop.min.x, crop.max.y}}) {
        polygon << toQt(view_from_plan * corner);
    }
    return polygon;
}

void drawMapPlan(QPainter& painter, const MapPlan& plan, const Theme& theme,
                 const ViewTransform& view) {
    painter.save();
    if (plan.crop) {
        QPainterPath path;
        path.addPolygon(outline(*plan.crop, view.viewFromWorld() * plan.image.worldFromPlan()));
        painter.setClipPath(path);
    }
    painter.setOpacity(plan.opacity);
    drawPlan(painter, plan.image, plan.inverted_at_night ? theme : dayTheme(), view);
    painter.restore();
}

}  // namespace

const DrawnTrail* BaseImage::find(RobotId robot, const std::string& name) const {
    const auto found = std::ranges::find_if(trails, [&](const DrawnTrail& trail) {
        return trail.robot == robot && trail.name == name;
    });
    return found == trails.end() ? nullptr : &*found;
}

BaseImage renderBase(const MapScene& scene, const ViewTransform& view, double device_ratio) {
    BaseImage base{QImage((QSizeF(view.width_px, view.height_px) * device_ratio).toSize(),
                          QImage::Format_RGB32),
                   view,
                   {},
                   0};
    base.image.setDevicePixelRatio(device_ratio);
    base.image.fill(scene.theme.background);
    QPainter painter(&base.image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const MapPlan& plan : scene.plans) drawMapPlan(painter, plan, scene.theme, view);
    for (const SceneTrail& earlier : scene.earlier) {
        drawTrail(painter, earlier.trail.track, earlier.pen, view);
    }
    for (const auto& [trail, pen, robot] : scene.trails) {
        base.trails.push_back({robot, trail.name, drawTrail(painter, trail.track, pen, view)});
    }
    return base;
}

void growBase(BaseImage& base, const LiveTrail& trail, const QPen& pen, RobotId robot) {
    const auto drawn = std::ranges::find_if(base.trails, [&](const DrawnTrail& each) {
        return each.robot == robot && each.name == trail.name;
    });
    if (drawn == base.trails.end() || drawn->end.points >= trail.track.size()) return;
    QPainter painter(&base.image);
    painter.setRenderHint(QPainter::Antialiasing);
    base.grown_points += trail.track.size() - drawn->end.points;
    drawn->end =
        drawTrailTail(painter, trail.track, pen, base.view, drawn->end, base.view.pixels_per_metre);
}

}  // namespace hedr
