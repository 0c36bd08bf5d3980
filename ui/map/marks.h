#pragma once

#include <QPainter>
#include <optional>

#include "core/geometry/frames.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// What lies on the map besides plan, trails and robot.

void drawHome(QPainter& painter, Point<View> at, const Theme& theme);

struct ScaleBar {
    double length_m = 0.0;
    double length_px = 0.0;
};
// The longest of 1, 2, 5 × 10^n metres that is not longer than `most_px`.
ScaleBar scaleBar(double pixels_per_metre, double most_px);
void drawScaleBar(QPainter& painter, QPointF right_bottom, const ScaleBar& bar, const Theme& theme);

// A dial that shows where 0° and 90° are on the screen, with the robot's heading as its needle.
void drawDial(QPainter& painter, QPointF centre, double rotation_rad,
              std::optional<double> heading_rad, const Theme& theme);
inline constexpr double kDialReach_px = 52.0;  // with its labels

// Where the robot could have gone since it was last heard.
struct Reach {
    Point<View> centre{};
    double radius_px = 0.0;
    QString text;
};
void drawReach(QPainter& painter, const Reach& reach, const QRectF& inside, const QColor& colour,
               const Theme& theme);

// The dashed frame of a map that is no longer true.
void drawStaleFrame(QPainter& painter, const QRectF& rect, const QColor& colour);

}  // namespace hedr
