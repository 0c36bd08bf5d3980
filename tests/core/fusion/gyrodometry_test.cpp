#include "core/fusion/gyrodometry.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

double headingAfter(double odometry_rate_deg_s, double gyro_rate_deg_s, double dt_s, int steps) {
    Gyrodometry method({}, {});
    for (int i = 0; i < steps; ++i) {
        method.update({.dt_s = dt_s,
                       .odometry_turn_rad = radFromDeg(odometry_rate_deg_s * dt_s),
                       .gyro_turn_rad = radFromDeg(gyro_rate_deg_s * dt_s)});
    }
    return degFromRad(method.pose().heading_rad);
}

TEST(Gyrodometry, TakesTheWheelsWhileTheyAgreeWithTheGyro) {
    EXPECT_NEAR(headingAfter(1.0, 2.0, 0.1, 10), 1.0, 1e-9);
}

TEST(Gyrodometry, TakesTheGyroOverABump) {
    EXPECT_NEAR(headingAfter(0.0, 7.0, 0.1, 10), 7.0, 1e-9);
}

TEST(Gyrodometry, ItsThresholdIsARateWhateverTheSampling) {
    for (const double dt_s : {0.01, 0.1, 0.5}) {
        const int steps = static_cast<int>(1.0 / dt_s);
        EXPECT_NEAR(headingAfter(0.0, 1.2, dt_s, steps), 0.0, 1e-9) << dt_s;
        EXPECT_NEAR(headingAfter(0.0, 1.3, dt_s, steps), 1.3, 1e-9) << dt_s;
    }
}

TEST(Gyrodometry, EqualityIsOdometry) {
    Gyrodometry method({}, {.threshold_rad_s = 0.5});
    method.update({.dt_s = 1.0, .odometry_turn_rad = 0.0, .gyro_turn_rad = 0.5});
    EXPECT_EQ(method.pose().heading_rad, 0.0);
}

// Eq. (3) as printed multiplies the interval's angle by T once more.
TEST(Gyrodometry, PrintedEquation3ShrinksATurnByTheSamplingTime) {
    const double dt_s = 0.1;
    const double turn_deg_per_step = 0.7;
    double printed_deg = 0.0;
    for (int i = 0; i < 10; ++i) printed_deg += turn_deg_per_step * dt_s;
    EXPECT_NEAR(printed_deg, 0.7, 1e-9);
    EXPECT_NEAR(headingAfter(0.0, 7.0, dt_s, 10), 7.0, 1e-9);
}

}  // namespace
}  // namespace hedr
