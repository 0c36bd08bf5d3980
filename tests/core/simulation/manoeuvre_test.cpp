#include "core/simulation/manoeuvre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr Pace kPace{.speed_m_s = 0.5, .turn_rate_rad_s = 1.0, .ramp_s = 0.4};

TEST(Manoeuvre, EndsWhereItWasSentTo) {
    const std::array way{Manoeuvre{.distance_m = 2.0}, Manoeuvre{.turn_rad = 0.5 * kPi},
                         Manoeuvre{.pause_s = 1.0}, Manoeuvre{.distance_m = -1.0}};
    Pose<World> pose;
    for (const MotionStep& step : stepsOf(way, kPace, 50.0)) pose = after(pose, step);
    EXPECT_NEAR(pose.position.x, 2.0, 1e-9);
    EXPECT_NEAR(pose.position.y, -1.0, 1e-9);
    EXPECT_NEAR(pose.heading_rad, 0.5 * kPi, 1e-12);
}

TEST(Manoeuvre, DrivesAnArc) {
    const std::array way{Manoeuvre{.distance_m = kPi, .turn_rad = kPi}};
    Pose<World> pose;
    for (const MotionStep& step : stepsOf(way, kPace, 100.0)) pose = after(pose, step);
    EXPECT_NEAR(pose.position.x, 0.0, 1e-4);
    EXPECT_NEAR(pose.position.y, 2.0, 1e-4);
}

TEST(Manoeuvre, KeepsItsPaceAndBeginsAndEndsAtRest) {
    const std::array way{Manoeuvre{.distance_m = 2.0}};
    const auto steps = stepsOf(way, kPace, 50.0);
    EXPECT_NEAR(static_cast<double>(steps.size()) / 50.0, 2.0 / 0.5 + 0.4, 0.021);
    double fastest = 0.0;
    for (const MotionStep& step : steps) fastest = std::max(fastest, 50.0 * step.distance_m);
    EXPECT_NEAR(fastest, 0.5, 0.01);
    EXPECT_LT(50.0 * steps.front().distance_m, 0.05);
    EXPECT_LT(50.0 * steps.back().distance_m, 0.05);
}

TEST(Manoeuvre, StandsInAPause) {
    const std::array way{Manoeuvre{.pause_s = 2.0}};
    const auto steps = stepsOf(way, kPace, 10.0);
    ASSERT_EQ(steps.size(), 20U);
    for (const MotionStep& step : steps) {
        EXPECT_EQ(step.distance_m, 0.0);
        EXPECT_EQ(step.turn_rad, 0.0);
    }
}

}  // namespace
}  // namespace hedr
