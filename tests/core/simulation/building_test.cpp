#include "core/simulation/building.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hedr {
namespace {

bool inside(const Room& room, Point<Floor> p) {
    return p.x > room.min.x && p.x < room.max.x && p.y > room.min.y && p.y < room.max.y;
}

TEST(SampleBuilding, HasNoDeadEnd) {
    const CorridorGraph graph = sampleBuilding().corridors;
    for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
        EXPECT_GE(graph.neighbours(node).size(), 2U) << "node " << node;
    }
}

TEST(SampleBuilding, LeadsItsCorridorsThroughNoRoom) {
    const Building building = sampleBuilding();
    const CorridorGraph& graph = building.corridors;
    for (const auto& [from, to] : graph.edges) {
        for (double share = 0.0; share <= 1.0; share += 0.01) {
            const Point<Floor> p =
                graph.nodes[from] + share * (graph.nodes[to] - graph.nodes[from]);
            EXPECT_TRUE(std::ranges::none_of(building.floor.rooms,
                                             [&](const Room& room) { return inside(room, p); }))
                << p.x << ' ' << p.y;
        }
    }
}

TEST(SampleBuilding, GivesEveryRoomADoor) {
    const FloorPlan floor = sampleBuilding().floor;
    for (const Room& room : floor.rooms) {
        double wall_m = 0.0;
        for (const Wall& wall : floor.walls) {
            for (const double y : {room.min.y, room.max.y}) {
                if (wall.from.y != y || wall.to.y != y) continue;
                wall_m += std::max(
                    0.0, std::min(wall.to.x, room.max.x) - std::max(wall.from.x, room.min.x));
            }
        }
        const double full_m = 2.0 * (room.max.x - room.min.x);
        EXPECT_LT(wall_m, full_m - 1.0) << room.name;
        EXPECT_GT(wall_m, full_m - 7.0) << room.name;
    }
}

TEST(SampleBuilding, StartsInACorridorBesideTheFirstNode) {
    const Building building = sampleBuilding();
    const auto neighbours = building.corridors.neighbours(building.start);
    EXPECT_TRUE(std::ranges::count(neighbours, building.first_towards) == 1);
}

}  // namespace
}  // namespace hedr
