#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/frames.h"

namespace hedr {

// What a cell of a plan is for a robot: a wall (or furniture), a place it can be, or nothing known
// (grey in a ROS map, outside of the building's outline).
enum class Cell : std::uint8_t { kWall, kFree, kUnknown };

// Where a robot can be on a plan. Cells are squares of `plan_px_per_cell` plan pixels; the first
// one lies in the plan's upper left corner, rows go down.
struct FreeSpace {
    int width = 0;
    int height = 0;
    double plan_px_per_cell = 1.0;
    std::vector<Cell> cells;

    Cell at(Point<Plan> p) const;  // kUnknown beside the plan
};

}  // namespace hedr
