#include "ui/map/robot_symbol.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "ui/map/qt_geometry.h"

namespace hedr {
namespace {

constexpr double kLeastLength_px = 34.0;
constexpr double kOutline_px = 3.0;

constexpr double kPointer_px = 22.0;

// Where the way from the middle to a robot out of sight leaves the rectangle.
QPointF edgePoint(const RobotSymbol& robot, const QRectF& inside) {
    const QPointF way = toQt(robot.position) - inside.center();
    const double shrink = std::min(inside.width() / 2.0 / std::max(1e-9, std::abs(way.x())),
                                   inside.height() / 2.0 / std::max(1e-9, std::abs(way.y())));
    return inside.center() + shrink * way;
}

// Each has another outline, also where it is small, and one end that is clearly the front.
QPolygonF unitShape(RobotShape shape) {
    switch (shape) {
        case RobotShape::kArrow:
            return {{{0.5, 0.0}, {-0.5, 0.36}, {-0.28, 0.0}, {-0.5, -0.36}, {0.5, 0.0}}};
        case RobotShape::kWedge:
            return {{{0.5, 0.0}, {-0.42, 0.44}, {-0.42, -0.44}, {0.5, 0.0}}};
        case RobotShape::kHouse:
            return {{{0.5, 0.0},
                     {0.08, 0.36},
                     {-0.44, 0.36},
                     {-0.44, -0.36},
                     {0.08, -0.36},
                     {0.5, 0.0}}};
        case RobotShape::kKite:
            return {{{0.5, 0.0}, {-0.16, 0.4}, {-0.5, 0.0}, {-0.16, -0.4}, {0.5, 0.0}}};
    }
    return {};
}

double drawnLength(const RobotSymbol& robot) { return std::max(kLeastLength_px, robot.length_px); }

}  // namespace

QPolygonF robotShape(double length, RobotShape shape) {
    return QTransform::fromScale(length, length).map(unitShape(shape));
}

QColor ageColour(LinkState state, const Theme& theme) {
    if (state == LinkState::kLost) return theme.alarm;
    return state == LinkState::kStale ? theme.warning : theme.dim;
}

QRectF robotBounds(const RobotSymbol& robot) {
    const double reach = 0.62 * drawnLength(robot) + 2.0 * kOutline_px;
    return QRectF(toQt(robot.position), QSizeF()).adjusted(-reach, -reach, reach, reach);
}

void drawRobot(QPainter& painter, const RobotSymbol& robot, const Theme& theme) {
    const bool old = isOld(robot.state);
    const QColor aged = ageColour(robot.state, theme);
    const QPolygonF head = robotShape(drawnLength(robot), robot.shape);
    painter.save();
    painter.translate(toQt(robot.position));
    painter.rotate(-degFromRad(robot.heading_on_screen_rad));
    // A light outline keeps it readable on any plan and on its own trail.
    painter.setPen(
        QPen(theme.paper, 2.0 * kOutline_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(theme.paper);
    painter.drawPolygon(head);
    painter.setPen(QPen(old ? aged : theme.accent, old ? 2.5 : 1.0, Qt::SolidLine, Qt::RoundCap,
                        old ? Qt::RoundJoin : Qt::BevelJoin));
    painter.setBrush(old ? QBrush(theme.paper) : QBrush(theme.accent));
    if (robot.state == LinkState::kLost) {
        painter.drawPolygon(head);
        painter.setBrush(QBrush(aged, Qt::BDiagPattern));
    }
    painter.drawPolygon(head);
    painter.restore();
}

QRectF edgePointerBounds(const RobotSymbol& robot, const QRectF& inside) {
    const double reach = kPointer_px + 1.0;
    return QRectF(edgePoint(robot, inside), QSizeF()).adjusted(-reach, -reach, reach, reach);
}

void drawEdgePointer(QPainter& painter, const RobotSymbol& robot, const QRectF& inside,
                     const Theme& theme) {
    const QPointF way = toQt(robot.position) - inside.center();
    const QColor colour = isOld(robot.state) ? ageColour(robot.state, theme) : theme.accent;
    painter.save();
    painter.translate(edgePoint(robot, inside));
    painter.setPen(QPen(theme.hairline, 1.0));
    painter.setBrush(theme.chrome);
    painter.drawEllipse(QPointF(), kPointer_px, kPointer_px);
    painter.rotate(degFromRad(std::atan2(way.y(), way.x())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF({{15.0, 0.0}, {-7.0, 9.0}, {-7.0, -9.0}}));
    painter.restore();
}

}  // namespace hedr
