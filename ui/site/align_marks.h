#pragma once

#include <QPainter>
#include <optional>

#include "ui/map/view_transform.h"
#include "ui/site/alignment.h"
#include "ui/theme.h"

namespace hedr {

// Which mark of an alignment a pointer can take hold of.
enum class Handle { kMapEnd, kPlanEnd, kRuler, kCorner, kTurn };

struct GrabbedHandle {
    Handle handle = Handle::kMapEnd;
    std::size_t index = 0;  // of the point, the ruler's end, the corner
};

// Where a plan's corners (clockwise from the upper left one) and the handle that turns it lie.
struct PlanFrame {
    std::array<Point<View>, 4> corners{};
    Point<View> turn{};
};
PlanFrame planFrame(const PlanLevel& plan, const PlanPlacement& placement,
                    const ViewTransform& view);

// What of an alignment lies on the map, by method.
struct AlignMarks {
    const Alignment& alignment;
    const AlignmentFit& fit;
    const PlanLevel& plan;  // its size
};

void drawPoints(QPainter& painter, const AlignMarks& marks, const ViewTransform& view,
                const Theme& theme);
void drawRuler(QPainter& painter, const AlignMarks& marks, const ViewTransform& view,
               const Theme& theme);
void drawFrame(QPainter& painter, const PlanFrame& frame, const Theme& theme);

// The handle within reach of the pointer, the nearest first.
std::optional<GrabbedHandle> pointHandleAt(const AlignMarks& marks, const ViewTransform& view,
                                           Point<View> at);
std::optional<GrabbedHandle> rulerHandleAt(const AlignMarks& marks, const ViewTransform& view,
                                           Point<View> at);
std::optional<GrabbedHandle> frameHandleAt(const PlanFrame& frame, Point<View> at);

}  // namespace hedr
