#pragma once

#include <QPainter>

#include "core/geometry/frames.h"
#include "ui/link_state.h"
#include "ui/robot_mark.h"
#include "ui/theme.h"

namespace hedr {

struct RobotSymbol {
    Point<View> position{};
    double heading_on_screen_rad = 0.0;  // counter-clockwise, 0 to the right
    double length_px = 0.0;              // true to scale; drawn no smaller than can be seen
    LinkState state = LinkState::kLive;
    RobotShape shape = RobotShape::kArrow;
};

// Full while live, hollow when old, hatched when lost: the shape tells, not only the colour.
void drawRobot(QPainter& painter, const RobotSymbol& robot, const Theme& theme);
// The colour of what is no longer true.
QColor ageColour(LinkState state, const Theme& theme);

// It points to the right, its middle at the origin.
QPolygonF robotShape(double length, RobotShape shape);

QRectF robotBounds(const RobotSymbol& robot);

// A pointer at the edge of `inside` towards a robot that lies outside of it.
void drawEdgePointer(QPainter& painter, const RobotSymbol& robot, const QRectF& inside,
                     const Theme& theme);
QRectF edgePointerBounds(const RobotSymbol& robot, const QRectF& inside);

}  // namespace hedr
