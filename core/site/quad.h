#pragma once

#include <array>

#include "core/geometry/frames.h"

namespace hedr {

// A rectangle as a photo shows it, in pixels of the photo. A corner may lie outside of it.
struct Quad {
    std::array<Point<Plan>, 4> corners{};  // upper left, upper right, lower right, lower left
    friend bool operator==(const Quad&, const Quad&) = default;
};

}  // namespace hedr
