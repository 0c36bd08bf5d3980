#include "core/simulation/labmate_bumps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hedr {
namespace {

constexpr LabmateBumps kQuiet{.gyro_drift_rad_s = 0.0, .gyro_noise_rad_s_sqrthz = 0.0};

double endHeadingDeg(const SimulatedMission& mission) {
    return degFromRad(mission.truth.back().pose.heading_rad);
}

TEST(LabmateBumps, TurnTheRobotTowardsTheWheelThatCrossesThem) {
    EXPECT_NEAR(endHeadingDeg(simulate(LabmateBumps{}, 1)), -9.0, 1e-6);
    LabmateBumps large{};
    large.residual_6mm_rad = 0.0;
    large.residual_9mm_rad = 0.0;
    EXPECT_NEAR(endHeadingDeg(simulate(large, 1)), -4.0, 1e-6);
}

TEST(LabmateBumps, LeaveTheEncodersEqualAtTheEnd) {
    const SimulatedMission mission = simulate(LabmateBumps{}, 2);
    const auto ticks = std::get<WheelTicks>(mission.sensors.back().odometry);
    EXPECT_LE(std::abs(ticks.left - ticks.right), 1);
    EXPECT_EQ(mission.truth.back().t_s, 140.0);
}

TEST(LabmateBumps, SwerveToBothSides) {
    const SimulatedMission mission = simulate(LabmateBumps{}, 3);
    std::int64_t most = 0;
    std::int64_t least = 0;
    for (std::size_t i = 1; i < mission.sensors.size(); ++i) {
        const auto before = std::get<WheelTicks>(mission.sensors[i - 1].odometry);
        const auto now = std::get<WheelTicks>(mission.sensors[i].odometry);
        const std::int64_t turn = (now.right - before.right) - (now.left - before.left);
        most = std::max(most, turn);
        least = std::min(least, turn);
    }
    EXPECT_GE(most, 4);
    EXPECT_LE(least, -4);
}

TEST(LabmateBumps, AreSeenByTheGyroAsTheyAre) {
    const SimulatedMission mission = simulate(kQuiet, 4);
    double heading_rad = 0.0;
    for (const SensorReport& report : mission.sensors)
        heading_rad += 0.1 * std::get<GyroRate>(report.gyro).rad_s;
    EXPECT_NEAR(heading_rad, mission.truth.back().pose.heading_rad, 1e-9);
}

TEST(LabmateBumps, LoseTheSameWayWhetherSuddenlyOrSlowly) {
    LabmateBumps slow = kQuiet;
    slow.held_share = 0.2;
    EXPECT_NEAR(endHeadingDeg(simulate(slow, 5)), endHeadingDeg(simulate(kQuiet, 5)), 1e-6);
}

}  // namespace
}  // namespace hedr
