#include "core/site/floor_drawing.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/simulation/building.h"
#include "core/site/placement_file.h"
#include "core/site/raster_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

FloorPlan box() {
    const double w = 0.2;
    return {{},
            {{{0, 0}, {4, 0}, w}, {{0, 2}, {4, 2}, w}, {{0, 0}, {0, 2}, w}, {{4, 0}, {4, 2}, w}}};
}

// Blue of the pixel at a point of the floor.
int inkAt(const PlanImage& plan, const Pose<World>& floor_origin, Point<Floor> point) {
    const auto plan_from_floor =
        plan.worldFromPlan().inverse() * rigidTransform<World, Floor>(floor_origin);
    const Point<Plan> pixel = plan_from_floor * point;
    const PlanLevel& level = plan.levels.front();
    const auto index =
        static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(level.width_px) +
        static_cast<std::size_t>(pixel.x);
    return level.pixels->at(4 * index);
}

TEST(DrawFloorPlan, ReachesToTheOuterFacesOfTheWalls) {
    const PlanImage plan = drawFloorPlan(box(), 0.05);
    EXPECT_EQ(plan.levels.front().width_px, 84);
    EXPECT_EQ(plan.levels.front().height_px, 44);
    EXPECT_NEAR(plan.placement.origin.position.x, -0.1, 1e-12);
    EXPECT_NEAR(plan.placement.origin.position.y, -0.1, 1e-12);
}

TEST(DrawFloorPlan, PutsWallsWhereTheyAreHoweverTheFloorLies) {
    for (const Pose<World>& origin : {Pose<World>{}, Pose<World>{{5.0, -3.0}, radFromDeg(30.0)}}) {
        const PlanImage plan = drawFloorPlan(box(), 0.05, origin);
        EXPECT_EQ(inkAt(plan, origin, {2.0, 0.0}), 0x44);
        EXPECT_EQ(inkAt(plan, origin, {0.05, 1.0}), 0x44);
        EXPECT_EQ(inkAt(plan, origin, {2.0, 1.0}), 0xFF);
        EXPECT_EQ(inkAt(plan, origin, {0.2, 1.0}), 0xFF);
    }
}

TEST(DrawFloorPlan, LeavesDoorsOpenAndTintsRooms) {
    const Building building = sampleBuilding();
    const PlanImage plan = planOf(building);
    EXPECT_EQ(inkAt(plan, {}, {45.0, 12.06}), 0xF8);  // the door of the atrium
    EXPECT_EQ(inkAt(plan, {}, {35.0, 12.0}), 0x44);   // its wall
    EXPECT_EQ(inkAt(plan, {}, {45.0, 10.5}), 0xFF);   // the corridor
    EXPECT_EQ(inkAt(plan, {}, {45.0, 35.0}), 0xF8);
}

TEST(SampleBuilding, LooksLikeTheImageThatIsShipped) {
    const fs::path shipped = fs::path(HEDR_SOURCE_DIR) / "assets/sample_building";
    const fs::path fresh = fs::path(HEDR_BINARY_DIR) / "sample_building";
    fs::create_directories(fresh);
    const PlanImage plan = planOf(sampleBuilding());
    ASSERT_TRUE(savePlanImage(plan.levels.front(), fresh / "plan.png"));
    ASSERT_TRUE(savePlacement({"plan.png", plan.placement}, fresh / "plan.toml"));

    const auto old = loadPlan(shipped / "plan.toml");
    ASSERT_TRUE(old) << old.error().detail;
    EXPECT_EQ(old->placement, plan.placement) << "the new one is in " << fresh;
    EXPECT_EQ(old->levels.front().width_px, plan.levels.front().width_px);
    EXPECT_TRUE(*old->levels.front().pixels == *plan.levels.front().pixels)
        << "the new one is in " << fresh;
}

}  // namespace
}  // namespace hedr
