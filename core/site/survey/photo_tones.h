#pragma once

#include <vector>

#include "core/geometry/frames.h"
#include "core/site/plan.h"

namespace hedr {

struct Small {};  // pixels of a reduced photo, x right, y down, (0, 0) the outer top left corner

// A photo reduced to what its edges tell: the logarithm of the brightness, so that a step of a
// tenth is one in light and in shadow, and its slope. Of a colour the darkest channel counts: it
// sets a white sheet off against wood and skin.
struct PhotoTones {
    int width_px = 0;
    int height_px = 0;
    double photo_px_per_px = 1.0;
    std::vector<float> broad{};    // the tone without grain and thin lines, row after row
    std::vector<float> slope_x{};  // of the tone, per pixel
    std::vector<float> slope_y{};

    bool contains(Point<Small> p) const {
        return p.x >= 0.0 && p.y >= 0.0 && p.x < width_px && p.y < height_px;
    }
    std::size_t index(Point<Small> p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_px) +
               static_cast<std::size_t>(p.x);
    }
    Vector<Small> slope(Point<Small> p) const {
        return {static_cast<double>(slope_x[index(p)]), static_cast<double>(slope_y[index(p)])};
    }
};

// At most `most_px` wide and high.
PhotoTones photoTones(const PlanLevel& photo, int most_px);

}  // namespace hedr
