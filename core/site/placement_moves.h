#pragma once

#include "core/site/plan.h"

namespace hedr {

// What an operator does to a plan by hand.

PlanPlacement movedBy(const PlanPlacement& placement, Vector<World> by);
// Counter-clockwise, about a point that stays where it is.
PlanPlacement turnedAbout(const PlanPlacement& placement, Point<World> fixed, double angle_rad);
PlanPlacement scaledAbout(const PlanPlacement& placement, Point<World> fixed, double factor);

}  // namespace hedr
