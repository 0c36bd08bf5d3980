#pragma once

#include <string>
#include <vector>

#include "core/geometry/frames.h"

namespace hedr {

struct Floor {};  // metres of a building's own drawing, x right, y up

struct Wall {
    Point<Floor> from{};
    Point<Floor> to{};
    double thickness_m = 0.15;
};

struct Room {
    std::string name;
    Point<Floor> min{};
    Point<Floor> max{};
};

// One floor of a building as an architect draws it. A door is a gap between two walls.
struct FloorPlan {
    std::vector<Room> rooms;
    std::vector<Wall> walls;
};

}  // namespace hedr
