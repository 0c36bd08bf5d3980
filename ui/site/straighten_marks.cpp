#include "ui/site/straighten_marks.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/map/plan_layer.h"
#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

constexpr double kReach_px = 24.0;
constexpr double kHandle_px = 13.0;  // radius; its inside shows the corner itself
constexpr double kLoupe_px = 84.0;   // radius
constexpr double kLoupeDistance_px = 132.0;
constexpr double kMagnified = 3.0;

void drawRing(QPainter& painter, QPointF at, double radius_px, const QColor& colour,
              const Theme& theme) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.chrome, 7.0));
    painter.drawEllipse(at, radius_px, radius_px);
    painter.setPen(QPen(colour, 3.5));
    painter.drawEllipse(at, radius_px, radius_px);
}

// Where the pointer does not cover it.
QPointF loupeCentre(QPointF corner, const ViewTransform& view) {
    const QPointF way = QPointF(view.width_px, view.height_px) / 2.0 - corner;
    const double length_px = std::max(1.0, std::hypot(way.x(), way.y()));
    return corner + kLoupeDistance_px / length_px * way;
}

}  // namespace

ViewCorners viewCorners(const Quad& quad, const Transform<View, Plan>& view_from_photo) {
    ViewCorners corners{};
    std::ranges::transform(quad.corners, corners.begin(),
                           [&](Point<Plan> corner) { return view_from_photo * corner; });
    return corners;
}

std::size_t nearestCorner(const ViewCorners& corners, Point<View> at) {
    const auto distance_px = [&](Point<View> corner) { return (corner - at).length(); };
    return static_cast<std::size_t>(std::ranges::min_element(corners, {}, distance_px) -
                                    corners.begin());
}

std::optional<std::size_t> cornerAt(const ViewCorners& corners, Point<View> at) {
    const std::size_t nearest = nearestCorner(corners, at);
    if ((corners[nearest] - at).length() > kReach_px) return {};
    return nearest;
}

void drawCorners(QPainter& painter, const ViewCorners& corners, const QColor& colour,
                 const Theme& theme) {
    QPolygonF outline;
    for (const Point<View>& corner : corners) outline << toQt(corner);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.chrome, 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(outline);
    painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(outline);
    for (const QPointF& corner : outline) drawRing(painter, corner, kHandle_px, colour, theme);
}

void drawLoupe(QPainter& painter, const Loupe& loupe, const ViewTransform& view,
               const Theme& theme) {
    const Point<View> corner = loupe.corners.at(loupe.corner);
    const QPointF centre = loupeCentre(toQt(corner), view);
    const ViewTransform near{view.worldFromView() * corner, kMagnified * view.pixels_per_metre,
                             view.rotation_rad, 2.0 * kLoupe_px, 2.0 * kLoupe_px};
    QPainterPath glass;
    glass.addEllipse(centre, kLoupe_px, kLoupe_px);
    painter.save();
    painter.setClipPath(glass);
    painter.fillPath(glass, theme.background);
    painter.save();
    painter.translate(centre - QPointF(kLoupe_px, kLoupe_px));
    drawPlan(painter, loupe.photo, loupe.photo_theme, near);
    painter.restore();
    painter.setPen(QPen(loupe.colour, 1.5));
    for (const std::size_t neighbour : {(loupe.corner + 1) % 4, (loupe.corner + 3) % 4}) {
        const QPointF side = toQt(loupe.corners[neighbour]) - toQt(corner);
        painter.drawLine(centre, centre + kMagnified * side);
    }
    painter.restore();
    drawRing(painter, centre, kLoupe_px, loupe.colour, theme);
}

}  // namespace hedr
