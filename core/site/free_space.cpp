#include "core/site/free_space.h"

#include <cmath>

namespace hedr {

Cell FreeSpace::at(Point<Plan> p) const {
    const double column = std::floor(p.x / plan_px_per_cell);
    const double row = std::floor(p.y / plan_px_per_cell);
    const bool inside = column >= 0.0 && row >= 0.0 && column < width && row < height;
    if (!inside) return Cell::kUnknown;  // also where p is not a number
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(column)];
}

}  // namespace hedr
