#include "core/simulation/route.h"

#include <gtest/gtest.h>

#include <vector>

namespace hedr {
namespace {

std::vector<std::size_t> wander(double budget_m, std::uint64_t seed) {
    const Building building = sampleBuilding();
    Route route(building.corridors, building.home);
    Random random(seed);
    std::vector<std::size_t> nodes{building.home, building.first_towards};
    for (;;) {
        budget_m -= building.corridors.length_m(*(nodes.end() - 2), nodes.back());
        const auto next = route.next(*(nodes.end() - 2), nodes.back(), budget_m, random);
        if (!next) return nodes;
        nodes.push_back(*next);
    }
}

TEST(Route, NeverTurnsBackAndEndsAtHomeWithinItsBudget) {
    const Building building = sampleBuilding();
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const auto nodes = wander(700.0, seed);
        double driven_m = 0.0;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            driven_m += building.corridors.length_m(nodes[i - 1], nodes[i]);
            if (i > 1) {
                EXPECT_NE(nodes[i], nodes[i - 2]);
            }
        }
        EXPECT_EQ(nodes.back(), building.home);
        EXPECT_LE(driven_m, 700.0);
        EXPECT_GT(driven_m, 500.0);
    }
}

TEST(Route, TakesTheShortestWayHomeWhenNothingFits) {
    const auto nodes = wander(0.0, 1);
    EXPECT_EQ(nodes, (std::vector<std::size_t>{12, 1, 5, 4, 0, 12}));
}

}  // namespace
}  // namespace hedr
