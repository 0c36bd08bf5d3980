#include "core/simulation/gyrostar_warmup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

constexpr GyrostarWarmup kExact{.drift_spread = 0.0, .gyro_noise_rad_s = 0.0};

double gyro(const SimulatedMission& mission, std::size_t sample) {
    return std::get<GyroRate>(mission.sensors[sample].gyro).rad_s;
}

TEST(GyrostarWarmup, StandsForTwoThousandSamplesAndDrivesForTenMinutes) {
    const SimulatedMission mission = simulate(GyrostarWarmup{}, 1);
    for (std::size_t i = 0; i <= 2000; ++i) ASSERT_EQ(mission.truth[i].pose, mission.start);
    EXPECT_NE(mission.truth[2010].pose, mission.start);
    EXPECT_NEAR(mission.truth.back().t_s, 660.0, 0.031);
}

TEST(GyrostarWarmup, HasTheBiasOfThePaper) {
    const SimulatedMission mission = simulate(kExact, 1);
    EXPECT_NEAR(degFromRad(gyro(mission, 0)), -0.264, 1e-9);
    const double after_a_minute = 0.153 * (1.0 - std::exp(-60.0 / (60.0 * 5.64))) - 0.264;
    EXPECT_NEAR(degFromRad(gyro(mission, 2000)), after_a_minute, 1e-4);
}

TEST(GyrostarWarmup, ThatHasBeenOnForLongHasABiasThatStays) {
    GyrostarWarmup warm = kExact;
    warm.warm_for_s = 1e5;
    const SimulatedMission mission = simulate(warm, 1);
    EXPECT_NEAR(degFromRad(gyro(mission, 0)), 0.153 - 0.264, 1e-9);
    EXPECT_NEAR(gyro(mission, 0), gyro(mission, 1500), 1e-12);
}

TEST(GyrostarWarmup, WritesTheFitIntoItsVehicleAndDiffersFromItByTheSpread) {
    const SimulatedMission mission = simulate(GyrostarWarmup{.gyro_noise_rad_s = 0.0}, 3);
    ASSERT_TRUE(mission.vehicle.gyro_drift.has_value());
    EXPECT_NEAR(degFromRad(mission.vehicle.gyro_drift->c1_rad_s), 0.153, 1e-12);
    EXPECT_NE(gyro(mission, 0), mission.vehicle.gyro_drift->c2_rad_s);
    EXPECT_NEAR(gyro(mission, 0), mission.vehicle.gyro_drift->c2_rad_s, radFromDeg(0.003));
}

TEST(GyrostarWarmup, ComesBackAlongItsLineFirst) {
    const SimulatedMission mission = simulate(GyrostarWarmup{}, 4);
    double farthest_m = 0.0;
    double back_m = 1e9;
    for (std::size_t i = 2000; i < 3500; ++i) {  // 45 s: forth and back
        const double x_m = mission.truth[i].pose.position.x;
        if (x_m > farthest_m) farthest_m = x_m;
        if (farthest_m > 39.0) back_m = std::min(back_m, x_m);
        ASSERT_EQ(mission.truth[i].pose.position.y, 0.0);
    }
    EXPECT_NEAR(farthest_m, 40.0, 1e-6);
    EXPECT_LT(back_m, 1.0);
}

}  // namespace
}  // namespace hedr
