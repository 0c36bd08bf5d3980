#include <QPaintEvent>
#include <QPainter>
#include <cmath>

#include "ui/format.h"
#include "ui/map/map_view.h"
#include "ui/map/qt_geometry.h"
#include "ui/map/trail_layer.h"

// The frame of the map view; its state and input are in map_view.cpp.
namespace hedr {
namespace {

constexpr int kMostScaleBar_px = 180;

}  // namespace

void MapView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBase(painter, event->rect());
    paintTails(painter);
    paintMarks(painter, event->region());
    if (tool_) tool_->paint(painter, view_, theme_);
}

void MapView::paintBase(QPainter& painter, const QRect& exposed) const {
    painter.fillRect(exposed, theme_.background);
    const BaseImage& base = keeper_.base();
    if (base.image.isNull()) return;
    const Transform<View, View> shown = view_.viewFromWorld() * base.view.worldFromView();
    const bool moved_only = base.view.pixels_per_metre == view_.pixels_per_metre &&
                            base.view.rotation_rad == view_.rotation_rad;
    if (moved_only) {
        painter.drawImage(QPointF(std::round(shown.offset().x()), std::round(shown.offset().y())),
                          base.image);
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(toQt(shown), true);
    painter.drawImage(QPointF(), base.image);
    painter.restore();
}

void MapView::paintTails(QPainter& painter) const {
    if (tailPoints() > kMostTailInAFrame) return;
    const BaseImage& base = keeper_.base();
    for (const LiveTrail* trail : drawnTrails()) {
        const DrawnTrail* drawn = base.find(trail->name);
        const TrailEnd end = drawn ? drawn->end : TrailEnd{};
        const double scale = drawn ? base.view.pixels_per_metre : view_.pixels_per_metre;
        drawTrailTail(painter, trail->track, penOf(*trail), view_, end, scale);
    }
}

void MapView::paintMarks(QPainter& painter, const QRegion& exposed) const {
    const auto robot = robotSymbol();
    const QRectF inside = freeRect().adjusted(24, 24, -24, -24);
    if (const auto home = model_.home(); home && model_.homeFloor() == floor_) {
        drawHome(painter, view_.viewFromWorld() * *home, theme_);
    }
    if (robot && reach_m_ > 0.0) {
        drawReach(painter,
                  {robot->position, reach_m_ * view_.pixels_per_metre,
                   tr("could be here: %1 after %2")
                       .arg(formatDistance(reach_m_), formatAge(link_.age_s))},
                  {inside, childrenRegion().united(dialRect().toAlignedRect())},
                  ageColour(link_.state, theme_), theme_);
    }
    const QColor sure = isOld(link_.state) ? ageColour(link_.state, theme_) : theme_.accent;
    if (const auto around = spread()) drawSpread(painter, *around, sure);
    if (robot) drawRobot(painter, *robot, theme_);
    if (robot && !QRectF(rect()).contains(toQt(robot->position))) {
        drawEdgePointer(painter, *robot, inside, theme_);
    }
    const auto pose = model_.pose();
    if (exposed.intersects(dialRect().toAlignedRect())) {
        drawDial(painter, dialCentre(), view_.rotation_rad,
                 pose ? std::optional(Needle{pose->heading_rad, link_.state}) : std::nullopt,
                 theme_);
    }
    const QPointF corner(width() - 24.0, height() - 32.0);
    if (exposed.intersects(
            QRect(corner.toPoint() - QPoint(kMostScaleBar_px + 40, 44), rect().bottomRight()))) {
        drawScaleBar(painter, corner, scaleBar(view_.pixels_per_metre, kMostScaleBar_px), theme_);
    }
    if (link_.state == LinkState::kStale || link_.state == LinkState::kLost) {
        drawStaleFrame(painter, rect(), ageColour(link_.state, theme_));
    }
}

}  // namespace hedr
