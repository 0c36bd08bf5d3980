#pragma once

#include <QPainter>
#include <optional>

#include "core/geometry/frames.h"
#include "core/track/track.h"
#include "ui/link_state.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// What lies on the map besides plan, trails and robot.

void drawHome(QPainter& painter, Point<View> at, const Theme& theme);

// How uncertain a position is: an ellipse of two standard deviations, as the strip has it.
struct Spread {
    Point<View> centre{};
    double major_px = 0.0;  // half axes
    double minor_px = 0.0;
    double angle_rad = 0.0;  // of the major one on the screen, counter-clockwise
};
Spread spreadOf(const PoseVariance& variance, Point<World> at, const ViewTransform& view);
void drawSpread(QPainter& painter, const Spread& spread, const QColor& colour);
QRectF spreadBounds(const Spread& spread);
// A larger one would only tint the plan: the strip says the figures.
bool fitsInto(const Spread& spread, const QSizeF& view_px);

struct ScaleBar {
    double length_m = 0.0;
    double length_px = 0.0;
};
// The longest of 1, 2, 5 × 10^n metres that is not longer than `most_px`.
ScaleBar scaleBar(double pixels_per_metre, double most_px);
void drawScaleBar(QPainter& painter, QPointF right_bottom, const ScaleBar& bar, const Theme& theme);

// The robot's heading; hollow where it is old.
struct Needle {
    double heading_rad = 0.0;
    LinkState state = LinkState::kLive;
};
// A dial that shows where 0° and 90° are on the screen.
void drawDial(QPainter& painter, QPointF centre, double rotation_rad,
              const std::optional<Needle>& needle, const Theme& theme);
inline constexpr double kDialReach_px = 52.0;  // with its labels

// Where the robot could have gone since it was last heard.
struct Reach {
    Point<View> centre{};
    double radius_px = 0.0;
    QString text;
};
// Where a label may lie.
struct LabelRoom {
    QRectF inside;
    QRegion covered{};  // by cards
};
void drawReach(QPainter& painter, const Reach& reach, const LabelRoom& room, const QColor& colour,
               const Theme& theme);
// Above, below, right or left of the circle, or of the robot where the circle is large: the first
// of them that is free.
QRectF reachLabelRect(const Reach& reach, const QSizeF& size, const LabelRoom& room);

// The dashed frame of a map that is no longer true.
void drawStaleFrame(QPainter& painter, const QRectF& rect, const QColor& colour);

}  // namespace hedr
