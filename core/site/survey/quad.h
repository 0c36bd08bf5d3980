#pragma once

#include <array>

#include "core/result.h"
#include "core/site/quad.h"

namespace hedr {

// Four corners in any order, put in the order of a Quad: its upper side is the one that is most
// nearly level.
Quad orderedQuad(const std::array<Point<Plan>, 4>& corners);

// Fails, kBadValue, where no rectangle looks like that: a coordinate that is no number, a side
// below 8 px, sides that cross, three corners on a line, a corner inside of the others' triangle,
// an order that mirrors, a side that is almost at the horizon.
Result<void> checkQuad(const Quad& quad);

}  // namespace hedr
