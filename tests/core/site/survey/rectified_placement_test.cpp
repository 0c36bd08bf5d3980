#include "core/site/survey/rectified_placement.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

constexpr int kWidth_px = 1200;
constexpr int kHeight_px = 900;
const Quad kQuad{{{{200.0, 150.0}, {950.0, 210.0}, {1100.0, 800.0}, {90.0, 760.0}}}};
const PlanPlacement kPhoto{0.03, {{4.0, -7.0}, 0.4}};

class RectifiedPlacement : public testing::Test {
  protected:
    const Rectification how = rectificationOf(kWidth_px, kHeight_px, kQuad).value();
    const PlanPlacement flat = rectifiedPlacement(kPhoto, kHeight_px, kQuad, how);
};

TEST_F(RectifiedPlacement, KeepsTheMiddleOfTheRectangleAndTheRotation) {
    const Point<Plan> middle = photoFromUnitSquare(kQuad) * Point<UnitSquare>{0.5, 0.5};
    const Point<Flat> in_flat = how.flat_from_photo * middle;
    const Point<World> before = worldFromPlan(kPhoto, kHeight_px) * middle;
    const Point<World> after =
        worldFromPlan(flat, how.height_px) * Point<Plan>{in_flat.x, in_flat.y};
    EXPECT_NEAR((after - before).length(), 0.0, 1e-9);
    EXPECT_DOUBLE_EQ(flat.origin.heading_rad, kPhoto.origin.heading_rad);
}

TEST_F(RectifiedPlacement, KeepsTheAreaOfTheRectangle) {
    constexpr double kQuadArea_px2 = 527'000.0;
    const Point<Flat> from = how.flat_from_photo * kQuad.corners[0];
    const Point<Flat> to = how.flat_from_photo * kQuad.corners[2];
    const double flat_area_px2 = (to.x - from.x) * (to.y - from.y);
    EXPECT_NEAR(flat_area_px2 * flat.resolution_m * flat.resolution_m,
                kQuadArea_px2 * kPhoto.resolution_m * kPhoto.resolution_m, 1e-6);
}

TEST_F(RectifiedPlacement, IsTakenBackExactly) {
    const PlanPlacement back = photoPlacement(flat, kHeight_px, kQuad, how);
    EXPECT_NEAR(back.resolution_m, kPhoto.resolution_m, 1e-12);
    EXPECT_NEAR((back.origin.position - kPhoto.origin.position).length(), 0.0, 1e-9);
}

}  // namespace
}  // namespace hedr
