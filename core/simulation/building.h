#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/site/floor_plan.h"
#include "core/site/plan.h"

namespace hedr {

// The middle lines of the corridors.
struct CorridorGraph {
    std::vector<Point<Floor>> nodes;
    std::vector<std::array<std::size_t, 2>> edges;

    std::vector<std::size_t> neighbours(std::size_t node) const;
    double length_m(std::size_t from, std::size_t to) const;
};

struct Building {
    FloorPlan floor;
    CorridorGraph corridors;
    std::size_t start = 0;              // the node where a drive starts
    std::size_t first_towards = 0;      // the neighbour of start that the robot looks at
    std::size_t home = 0;               // where it ends
    std::optional<std::size_t> goal{};  // where he has to go once
    bool task_at_goal = false;          // there is work to do, off the corridors
    Pose<World> origin{};               // of the floor's drawing in the world

    Transform<World, Floor> worldFromFloor() const { return rigidTransform<World, Floor>(origin); }
};

// A floor of 90 m x 54 m: rooms along two sides, five blocks, a ring of corridors 3 m wide and
// cross corridors of 2.5 m. No corridor is a dead end.
Building sampleBuilding();

// The same, and what is special about it.
Building buildingWithHall();          // ways across the atrium, 22 and 18 degrees off the corridors
Building buildingWithTask();          // a task in the atrium
Building buildingWithDiagonalWing();  // a wing at 45 degrees
// The drive starts in the atrium, `offset_rad` off the corridors' direction.
Building buildingEnteredAslant(double offset_rad);

// Its floor as an image of 0.04 m per pixel, in its place in the world.
PlanImage planOf(const Building& building);

}  // namespace hedr
