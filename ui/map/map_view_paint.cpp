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
    paintBase(painter, event->rect());
    painter.setRenderHint(QPainter::Antialiasing);
    paintTails(painter);
    paintMarks(painter, event->region());
    if (tool_) tool_->paint(painter, view_, theme_);
}

void MapView::paintBase(QPainter& painter, const QRect& exposed) const {
    const BaseImage& base = keeper_.base();
    if (base.image.isNull()) return painter.fillRect(exposed, theme_.background);
    const Transform<View, View> shown = view_.viewFromWorld() * base.view.worldFromView();
    const bool moved_only = base.view.pixels_per_metre == view_.pixels_per_metre &&
                            base.view.rotation_rad == view_.rotation_rad;
    if (moved_only) {
        const QPointF corner(std::round(shown.offset().x()), std::round(shown.offset().y()));
        const QRectF covered(corner, QSizeF(base.view.width_px, base.view.height_px));
        // It covers all of it, but for a moment of fast panning.
        if (!covered.contains(exposed)) painter.fillRect(exposed, theme_.background);
        return painter.drawImage(corner, base.image);
    }
    painter.fillRect(exposed, theme_.background);
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(toQt(shown), true);
    painter.drawImage(QPointF(), base.image);
    painter.restore();
}

void MapView::paintTails(QPainter& painter) const {
    if (tailPoints() > kMostTailInAFrame) return;
    const BaseImage& base = keeper_.base();
    for (const MapTrail& shown : drawnTrails()) {
        const DrawnTrail* drawn = base.find(shown.robot->id, shown.trail->name);
        const TrailEnd end = drawn ? drawn->end : TrailEnd{};
        const double scale = drawn ? base.view.pixels_per_metre : view_.pixels_per_metre;
        drawTrailTail(painter, shown.trail->track, penOf(shown), view_, end, scale);
    }
}

void MapView::paintMarks(QPainter& painter, const QRegion& exposed) const {
    for (const FleetRobot& robot : fleet_.robots()) {
        if (&robot != &fleet_.chosen()) paintRobot(painter, robot);
    }
    paintWhereabouts(painter);
    paintRobot(painter, fleet_.chosen());
    paintInstruments(painter, exposed);
    if (link_.state == LinkState::kStale || link_.state == LinkState::kLost) {
        drawStaleFrame(painter, rect(), ageColour(link_.state, theme_));
    }
}

void MapView::paintWhereabouts(QPainter& painter) const {
    if (const auto home = model().home(); home && model().homeFloor() == floor_) {
        drawHome(painter, view_.viewFromWorld() * *home, theme_);
    }
    const auto robot = symbolOf(fleet_.chosen());
    if (robot && reach_m_ > 0.0) {
        drawReach(painter,
                  {robot->position, reach_m_ * view_.pixels_per_metre,
                   tr("could be here: %1 after %2")
                       .arg(formatDistance(reach_m_), formatAge(link_.age_s))},
                  {pointerRect(), childrenRegion().united(dialRect().toAlignedRect())},
                  ageColour(link_.state, theme_), theme_);
    }
    const QColor sure = isOld(link_.state) ? ageColour(link_.state, theme_)
                                           : colourOf(fleet_.chosen().mark, theme_);
    if (const auto around = spread()) drawSpread(painter, *around, sure);
}

void MapView::paintRobot(QPainter& painter, const FleetRobot& robot) const {
    const auto symbol = symbolOf(robot);
    if (!symbol) return;
    const Theme theme = inColourOf(robot.mark, theme_);
    drawRobot(painter, *symbol, theme);
    if (const auto sign = call_signs_.find(robot.id); sign != call_signs_.end()) {
        sign->second.draw(painter, *symbol, theme);
    }
    if (!QRectF(rect()).contains(toQt(symbol->position))) {
        drawEdgePointer(painter, *symbol, pointerRect(), theme);
    }
}

void MapView::paintInstruments(QPainter& painter, const QRegion& exposed) const {
    const auto pose = model().pose();
    if (exposed.intersects(dialRect().toAlignedRect())) {
        drawDial(painter, dialCentre(), view_.rotation_rad,
                 pose ? std::optional(Needle{pose->heading_rad, link_.state}) : std::nullopt,
                 inColourOf(fleet_.chosen().mark, theme_));
    }
    const QPointF corner(width() - 24.0, height() - 32.0);
    if (exposed.intersects(
            QRect(corner.toPoint() - QPoint(kMostScaleBar_px + 40, 44), rect().bottomRight()))) {
        drawScaleBar(painter, corner, scaleBar(view_.pixels_per_metre, kMostScaleBar_px), theme_);
    }
}

}  // namespace hedr
