#include "core/simulation/delayed_steering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kZigzag_rad = radFromDeg(3.0);

// Course error of a robot that turns as it is told, degrees rms times sqrt 2.
double snakingDeg(double lag_s) {
    Random random(5);
    DelayedSteering steering(kZigzag_rad, kStep_s);
    steering.setVideoLag(lag_s);
    double error_rad = 0.0;
    double squares = 0.0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
        error_rad -= steering.yawRate_rad_s(error_rad, random) * kStep_s;
        squares += error_rad * error_rad;
    }
    return degFromRad(std::sqrt(2.0 * squares / kSteps));
}

// The hand moves for 0.3 s, not for an instant, which is felt where the picture is fresh.
TEST(DelayedSteering, SnakesByItsZigzagWhateverTheLag) {
    EXPECT_NEAR(snakingDeg(0.0), 3.0, 0.7);
    EXPECT_NEAR(snakingDeg(0.5), 3.0, 0.5);
    EXPECT_NEAR(snakingDeg(1.0), 3.0, 0.5);
}

TEST(DelayedSteering, CorrectsWhatItSawSomeTimeAgo) {
    Random random(1);
    DelayedSteering steering(0.0, kStep_s);
    steering.setVideoLag(0.7);  // and 0.3 s of reaction
    EXPECT_EQ(steering.yawRate_rad_s(0.0, random), 0.0);
    for (int i = 0; i < 99; ++i) EXPECT_EQ(steering.yawRate_rad_s(0.1, random), 0.0);
    static_cast<void>(steering.yawRate_rad_s(0.1, random));
    EXPECT_NEAR(steering.yawRate_rad_s(0.1, random), 0.07, 1e-12);
    steering.lookAnew();
    EXPECT_NEAR(steering.yawRate_rad_s(-0.1, random), -0.07, 1e-12);
}

}  // namespace
}  // namespace hedr
