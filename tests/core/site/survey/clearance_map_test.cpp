#include "core/site/survey/clearance_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/site/survey/driving_score.h"
#include "tests/core/site/survey/corridors.h"

namespace hedr {
namespace {

constexpr double kCell_m = 0.05;

// A corridor 2 m wide from x = 0 to x = 20, its middle at y = -5.
ClearanceMap corridor() { return {carved(20.0, 10.0, {{{0, -5}, {20, -5}}}), kCorridorPx_m}; }

TEST(ClearanceMap, MeasuresToTheNextWall) {
    const ClearanceMap map = corridor();
    EXPECT_NEAR(map.toWall_m({10.0, -5.0}), 1.0, kCell_m);
    EXPECT_NEAR(map.toWall_m({10.0, -4.3}), 0.3, kCell_m);
    EXPECT_EQ(map.toWall_m({10.0, -3.0}), 0.0);
    EXPECT_NEAR(map.toUnfree_m({10.0, -4.3}), 0.3, kCell_m);
}

TEST(ClearanceMap, LooksInADirection) {
    const ClearanceMap map = corridor();
    const double aslant = std::sqrt(0.5);
    EXPECT_NEAR(map.clearance_m({10.0, -4.8}, {0.0, 1.0}, 4.0), 0.8, 2 * kCell_m);
    EXPECT_NEAR(map.clearance_m({10.0, -4.8}, {0.0, -1.0}, 4.0), 1.2, 2 * kCell_m);
    EXPECT_NEAR(map.clearance_m({10.0, -5.0}, {aslant, aslant}, 4.0), 1.0 / aslant, 3 * kCell_m);
    EXPECT_EQ(map.clearance_m({10.0, -5.0}, {1.0, 0.0}, 4.0), 4.0);
}

TEST(ClearanceMap, HasNoWallsBesideThePlan) {
    const ClearanceMap map = corridor();
    for (const Point<PlanGround> beside :
         {Point<PlanGround>{-0.01, -5.0}, {20.01, -5.0}, {5.0, 0.01}}) {
        EXPECT_EQ(map.toWall_m(beside), ClearanceMap::kFar_m);
        EXPECT_EQ(map.toUnfree_m(beside), 0.0);
    }
    EXPECT_EQ(map.clearance_m({0.5, -5.0}, {-1.0, 0.0}, 4.0), 4.0);
}

TEST(ClearanceMap, AThinWallOutlivesCoarseCells) {
    FreeSpace space{.width = 10000, .height = 900, .plan_px_per_cell = 1.0, .cells = {}};
    space.cells.assign(10000 * 900, Cell::kFree);
    for (int row = 0; row < space.height; ++row) {
        space.cells[static_cast<std::size_t>(row) * 10000 + 4711] = Cell::kWall;
    }
    const ClearanceMap map(space, 0.05);
    EXPECT_EQ(map.toWall_m({4711.5 * 0.05, -20.0}), 0.0);
    EXPECT_NEAR(map.clearance_m({230.0, -20.0}, {1.0, 0.0}, 10.0), 5.55, 0.2);
}

TEST(DrivingScore, IsBestAlongTheMiddleOfACorridor) {
    const ClearanceMap map = corridor();
    const Vector<PlanGround> along{1.0, 0.0};
    const double middle = drivingScore(map, {10.0, -5.0}, along, 0.5);
    EXPECT_NEAR(middle, 1.0, 0.02);
    EXPECT_NEAR(drivingScore(map, {10.0, -5.5}, along, 0.5), std::exp(-0.5), 0.06);
    EXPECT_NEAR(drivingScore(map, {10.0, -5.0}, {0.0, 1.0}, 0.5), 0.0, 1e-6);
    EXPECT_LT(drivingScore(map, {10.0, -5.9}, along, 0.5), -0.3);
    EXPECT_NEAR(drivingScore(map, {10.0, -3.0}, along, 0.5), -2.0, 1e-6);
    EXPECT_NEAR(drivingScore(map, {10.0, 3.0}, along, 0.5), kScoreBesidePlan, 1e-6);
}

TEST(DrivingScore, IsLowWhereOnlyTheBeamsOfALaserWere) {
    FreeSpace space = carved(20.0, 10.0, {{{0, -5}, {20, -5}, 0.2}});
    for (Cell& cell : space.cells) {
        if (cell == Cell::kWall) cell = Cell::kUnknown;
    }
    const double score =
        drivingScore(ClearanceMap(space, kCorridorPx_m), {10.0, -5.0}, {1.0, 0.0}, 0.5);
    EXPECT_LT(score, -0.3);
    EXPECT_GT(score, kScoreBesidePlan);
}

}  // namespace
}  // namespace hedr
