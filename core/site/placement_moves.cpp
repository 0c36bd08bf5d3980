#include "core/site/placement_moves.h"

namespace hedr {

PlanPlacement movedBy(const PlanPlacement& placement, Vector<World> by) {
    PlanPlacement moved = placement;
    moved.origin.position = placement.origin.position + by;
    return moved;
}

PlanPlacement turnedAbout(const PlanPlacement& placement, Point<World> fixed, double angle_rad) {
    const auto turn = rigidTransform<World, World>({{}, angle_rad});
    PlanPlacement turned = placement;
    turned.origin.position = fixed + turn * (placement.origin.position - fixed);
    turned.origin.heading_rad += angle_rad;
    return turned;
}

PlanPlacement scaledAbout(const PlanPlacement& placement, Point<World> fixed, double factor) {
    PlanPlacement scaled = placement;
    scaled.resolution_m *= factor;
    scaled.origin.position = fixed + factor * (placement.origin.position - fixed);
    return scaled;
}

}  // namespace hedr
