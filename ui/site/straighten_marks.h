#pragma once

#include <QPainter>
#include <array>
#include <optional>

#include "core/site/plan.h"
#include "core/site/quad.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

using ViewCorners = std::array<Point<View>, 4>;  // in the order of a quad
ViewCorners viewCorners(const Quad& quad, const Transform<View, Plan>& view_from_photo);

// The corner whose handle is within reach of the pointer; the nearest one anyway.
std::optional<std::size_t> cornerAt(const ViewCorners& corners, Point<View> at);
std::size_t nearestCorner(const ViewCorners& corners, Point<View> at);

// The rectangle's sides and a handle at each corner, in a colour that says whether they will do.
void drawCorners(QPainter& painter, const ViewCorners& corners, const QColor& colour,
                 const Theme& theme);

// The photo around a corner, magnified, beside it towards the middle of the map.
struct Loupe {
    const PlanImage& photo;
    const Theme& photo_theme;
    const ViewCorners& corners;
    std::size_t corner = 0;
    QColor colour{};
};
void drawLoupe(QPainter& painter, const Loupe& loupe, const ViewTransform& view,
               const Theme& theme);

}  // namespace hedr
