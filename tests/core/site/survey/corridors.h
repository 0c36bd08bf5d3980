#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/geometry/frames.h"
#include "core/site/free_space.h"
#include "core/site/survey/clearance_map.h"

namespace hedr {

inline constexpr double kCorridorPx_m = 0.05;

struct Corridor {
    Point<PlanGround> from{};
    Point<PlanGround> to{};  // parallel to an axis
    double width_m = 2.0;
};

// Corridors cut out of a solid block; `height_m` below y = 0.
inline FreeSpace carved(double width_m, double height_m, const std::vector<Corridor>& corridors) {
    FreeSpace space{.width = static_cast<int>(std::lround(width_m / kCorridorPx_m)),
                    .height = static_cast<int>(std::lround(height_m / kCorridorPx_m)),
                    .cells = {}};
    for (int row = 0; row < space.height; ++row) {
        for (int column = 0; column < space.width; ++column) {
            const double x = (column + 0.5) * kCorridorPx_m;
            const double y = -(row + 0.5) * kCorridorPx_m;
            Cell cell = Cell::kWall;
            for (const Corridor& c : corridors) {
                const double half_m = 0.5 * c.width_m;
                const bool inside = x > std::min(c.from.x, c.to.x) - half_m &&
                                    x < std::max(c.from.x, c.to.x) + half_m &&
                                    y > std::min(c.from.y, c.to.y) - half_m &&
                                    y < std::max(c.from.y, c.to.y) + half_m;
                if (inside) cell = Cell::kFree;
            }
            space.cells.push_back(cell);
        }
    }
    return space;
}

// A drive from corner to corner, a point every 0.05 m.
inline std::vector<Point<PlanGround>> drivenAlong(const std::vector<Point<PlanGround>>& corners) {
    std::vector<Point<PlanGround>> places{corners.front()};
    for (const Point<PlanGround>& corner : corners) {
        const Vector<PlanGround> way = corner - places.back();
        const int steps = static_cast<int>(std::lround(way.length() / 0.05));
        const Point<PlanGround> begin = places.back();
        for (int i = 1; i <= steps; ++i) {
            places.push_back(begin + (static_cast<double>(i) / steps) * way);
        }
    }
    return places;
}

}  // namespace hedr
