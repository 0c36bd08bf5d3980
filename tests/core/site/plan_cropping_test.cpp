#include "core/site/plan_cropping.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

PlanImage someImage() {
    std::vector<std::uint8_t> pixels(40 * 30);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(i % 251);
    return {"floor.png",
            {{40, 30, 1, std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))}},
            {0.1, {{3.0, -2.0}, 0.7}}};
}

TEST(PlanCropping, KeepsEveryPixelWhereItWas) {
    const PlanImage whole = someImage();
    const PlanPart part = partOf({{10.2, 5.0}, {30.0, 19.5}}, whole.levels.front());
    const auto cropped = croppedPlan(whole, part);
    ASSERT_TRUE(cropped);
    EXPECT_EQ(cropped->levels.front().width_px, 20);
    EXPECT_EQ(cropped->levels.front().height_px, 15);
    EXPECT_EQ(cropped->levels.front().pixels->front(),
              whole.levels.front().pixels->at(5 * 40 + 10));
    const Point<World> was = whole.worldFromPlan() * Point<Plan>{17.0, 11.0};
    const Point<World> is = cropped->worldFromPlan() * Point<Plan>{7.0, 6.0};
    EXPECT_NEAR((was - is).length(), 0.0, 1e-12);
}

TEST(PlanCropping, GivesTheWholeImageItsPlacementBack) {
    const PlanImage whole = someImage();
    const PlanPart part = partOf({{10.2, 5.0}, {30.0, 19.5}}, whole.levels.front());
    const PlanPlacement back = placementOfWhole(croppedPlan(whole, part)->placement, part, 30);
    EXPECT_NEAR((back.origin.position - whole.placement.origin.position).length(), 0.0, 1e-12);
    EXPECT_EQ(back.origin.heading_rad, whole.placement.origin.heading_rad);
}

TEST(PlanCropping, StaysWithinTheImage) {
    const PlanPart part = partOf({{-5.0, 28.9}, {1e9, 1e9}}, someImage().levels.front());
    EXPECT_EQ(part.left_px, 0);
    EXPECT_EQ(part.width_px, 40);
    EXPECT_EQ(part.top_px, 28);
    EXPECT_EQ(part.height_px, 2);
}

}  // namespace
}  // namespace hedr
