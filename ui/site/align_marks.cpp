#include "ui/site/align_marks.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/map/qt_geometry.h"
#include "ui/site/map_marks.h"

namespace hedr {
namespace {

constexpr double kTurnArm_px = 40.0;

Transform<View, Plan> viewFromPlan(const AlignMarks& marks, const ViewTransform& view) {
    return view.viewFromWorld() * worldFromPlan(marks.alignment.placement, marks.plan.height_px);
}

bool within(Point<View> a, Point<View> b, double& nearest_px) {
    const double distance_px = (a - b).length();
    if (distance_px > kMarkReach_px || distance_px >= nearest_px) return false;
    nearest_px = distance_px;
    return true;
}

// A residual of a few centimetres is less than a pixel: how many times too long it is drawn.
double exaggeration(const AlignMarks& marks, const ViewTransform& view) {
    double longest_m = 0.0;
    if (!marks.fit.fit) return 1.0;
    for (const Vector<World>& residual : marks.fit.fit->residuals_m)
        longest_m = std::max(longest_m, residual.length());
    constexpr double kWanted_px = 40.0;
    const double longest_px = longest_m * view.pixels_per_metre;
    if (longest_px > kWanted_px || longest_px < 1e-6) return 1.0;
    return std::min(1000.0, std::pow(10.0, std::floor(std::log10(kWanted_px / longest_px))));
}

}  // namespace

PlanFrame planFrame(const PlanLevel& plan, const PlanPlacement& placement,
                    const ViewTransform& view) {
    const auto view_from_plan = view.viewFromWorld() * worldFromPlan(placement, plan.height_px);
    const double w = plan.width_px;
    const double h = plan.height_px;
    PlanFrame frame{{view_from_plan * Point<Plan>{0, 0}, view_from_plan * Point<Plan>{w, 0},
                     view_from_plan * Point<Plan>{w, h}, view_from_plan * Point<Plan>{0, h}},
                    {}};
    const Point<View> top = view_from_plan * Point<Plan>{w / 2.0, 0.0};
    const Vector<View> up = frame.corners[0] - frame.corners[3];
    frame.turn = top + kTurnArm_px / std::max(1e-9, up.length()) * up;
    return frame;
}

void drawPoints(QPainter& painter, const AlignMarks& marks, const ViewTransform& view,
                const Theme& theme) {
    const auto view_from_plan = viewFromPlan(marks, view);
    const double longer = exaggeration(marks, view);
    const auto& points = marks.alignment.points;
    const bool checked = marks.fit.fit && points.size() > 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point<View> on_map = view.viewFromWorld() * points[i].world;
        const Point<View> drawn = view_from_plan * points[i].plan;
        const QColor colour = checked && marks.fit.fit->worst == i ? theme.alarm : theme.accent;
        const Point<View> tip = on_map + longer * (drawn - on_map);
        if ((tip - on_map).length() > kNumberRadius_px) {
            drawLine(painter, toQt(on_map), toQt(tip), colour, theme);
            drawDot(painter, toQt(tip), 5.0, colour, theme);
        }
        drawNumber(painter, toQt(on_map), i + 1, colour, theme);
    }
    if (checked && longer > 1.0) {
        drawNote(
            painter,
            QCoreApplication::translate("AlignMarks", "Arrows are %1 times too long").arg(longer),
            theme);
    }
    if (marks.alignment.waiting) {
        drawDot(painter, toQt(view_from_plan * *marks.alignment.waiting), 8.0, theme.accent, theme);
    }
}

void drawRuler(QPainter& painter, const AlignMarks& marks, const ViewTransform& view,
               const Theme& theme) {
    const auto view_from_plan = viewFromPlan(marks, view);
    const auto& ruler = marks.alignment.ruler;
    if (ruler.size() == 2) {
        drawLine(painter, toQt(view_from_plan * ruler[0]), toQt(view_from_plan * ruler[1]),
                 theme.accent, theme);
    }
    for (std::size_t i = 0; i < ruler.size(); ++i) {
        drawNumber(painter, toQt(view_from_plan * ruler[i]), i + 1, theme.accent, theme);
    }
}

void drawFrame(QPainter& painter, const PlanFrame& frame, const Theme& theme) {
    QPolygonF outline;
    for (const Point<View>& corner : frame.corners) outline << toQt(corner);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.chrome, 5.0));
    painter.drawPolygon(outline);
    painter.setPen(QPen(theme.accent, 2.0));
    painter.drawPolygon(outline);
    const QPointF top = (outline[0] + outline[1]) / 2.0;
    painter.drawLine(top, toQt(frame.turn));
    for (const QPointF& corner : outline) drawDot(painter, corner, 8.0, theme.accent, theme);
    drawDot(painter, toQt(frame.turn), 8.0, theme.accent, theme);
}

std::optional<GrabbedHandle> pointHandleAt(const AlignMarks& marks, const ViewTransform& view,
                                           Point<View> at) {
    const auto view_from_plan = viewFromPlan(marks, view);
    std::optional<GrabbedHandle> found;
    double nearest_px = kMarkReach_px + 1.0;
    const auto& points = marks.alignment.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (within(view.viewFromWorld() * points[i].world, at, nearest_px))
            found = GrabbedHandle{Handle::kMapEnd, i};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (within(view_from_plan * points[i].plan, at, nearest_px))
            found = GrabbedHandle{Handle::kPlanEnd, i};
    }
    return found;
}

std::optional<GrabbedHandle> rulerHandleAt(const AlignMarks& marks, const ViewTransform& view,
                                           Point<View> at) {
    const auto view_from_plan = viewFromPlan(marks, view);
    std::optional<GrabbedHandle> found;
    double nearest_px = kMarkReach_px + 1.0;
    for (std::size_t i = 0; i < marks.alignment.ruler.size(); ++i) {
        if (within(view_from_plan * marks.alignment.ruler[i], at, nearest_px))
            found = GrabbedHandle{Handle::kRuler, i};
    }
    return found;
}

std::optional<GrabbedHandle> frameHandleAt(const PlanFrame& frame, Point<View> at) {
    std::optional<GrabbedHandle> found;
    double nearest_px = kMarkReach_px + 1.0;
    for (std::size_t i = 0; i < frame.corners.size(); ++i) {
        if (within(frame.corners[i], at, nearest_px)) found = GrabbedHandle{Handle::kCorner, i};
    }
    if (within(frame.turn, at, nearest_px)) found = GrabbedHandle{Handle::kTurn, 0};
    return found;
}

}  // namespace hedr
