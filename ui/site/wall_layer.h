#pragma once

#include <QImage>
#include <span>
#include <vector>

#include "core/site/free_space.h"
#include "core/site/wall_stroke.h"
#include "ui/map/map_plan.h"
#include "ui/map/view_transform.h"
#include "ui/theme.h"

namespace hedr {

// Where a plan has walls and where it is free, as it lies on the map.
struct WallCells {
    QImage cells{};  // a Cell per pixel
    Transform<World, Plan> world_from_cells{};
    bool any_walls = false;
};
WallCells wallCells(const FreeSpace& space, const MapPlan& plan);

QColor wallColour(const Theme& theme);
QColor freeColour(const Theme& theme);  // lets the plan shine through

// A picture as large as the view, transparent where nothing is known.
QImage wallPicture(std::span<const WallCells> plans, const ViewTransform& view, const Theme& theme,
                   double device_ratio);
// On such a picture: walls, and free space where walls were.
void drawStrokes(QImage& picture, std::span<const WallStroke> strokes, const ViewTransform& view,
                 const Theme& theme);

}  // namespace hedr
