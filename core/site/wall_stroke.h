#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/frames.h"

namespace hedr {

enum class WallPen : std::uint8_t { kWall, kEraser };

// A line that an operator has drawn: it makes walls, or free space.
struct WallStroke {
    WallPen pen = WallPen::kWall;
    double width_m = 0.2;
    std::vector<Point<World>> points{};
    friend bool operator==(const WallStroke&, const WallStroke&) = default;
};

}  // namespace hedr
