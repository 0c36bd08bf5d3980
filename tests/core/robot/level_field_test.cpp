#include "core/robot/level_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

TEST(LevelField, IsTheScaledOneToTheLastBitWithoutCorrelation) {
    const MagnetometerRange range{0.3, -0.7, 0.21, -0.33};
    for (int i = 0; i < 100; ++i) {
        const MagneticField field{std::cos(0.1 * i), std::sin(0.1 * i), 3.0};
        const double ahead = (field.x - 0.3) / 0.21;
        const double left = (field.y + 0.7) / -0.33;
        EXPECT_EQ(withoutIron(field, range).ahead, ahead);
        EXPECT_EQ(withoutIron(field, range).left, left);
        EXPECT_EQ(withoutIron(field, range).heading_rad(), std::atan2(-left, ahead));
    }
}

// A circle pressed to an ellipse askew.
TEST(LevelField, IsACircleForAnyEllipse) {
    const double xx = 0.5, yx = 0.2, yy = 0.3;
    const double range_y = std::hypot(yx, yy);
    const MagnetometerRange range{1.0, 2.0, xx, range_y, yx / range_y};
    for (int i = 0; i < 36; ++i) {
        const double heading_rad = radFromDeg(10.0 * i);
        const double ahead = std::cos(heading_rad);
        const double left = -std::sin(heading_rad);
        const LevelField level =
            withoutIron({1.0 + xx * ahead, 2.0 + yx * ahead + yy * left, 0.0}, range);
        EXPECT_NEAR(level.strength(), 1.0, 1e-12);
        EXPECT_NEAR(wrapAngle(level.heading_rad() - heading_rad), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace hedr
