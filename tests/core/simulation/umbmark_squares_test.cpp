#include "core/simulation/umbmark_squares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// Stretches in which the wheels stand for longer than a corner's stop.
int pausesOf(const SimulatedMission& mission) {
    int pauses = 0;
    double still_s = 0.0;
    for (std::size_t i = 1; i < mission.sensors.size(); ++i) {
        const double dt_s = mission.truth[i].t_s - mission.truth[i - 1].t_s;
        const bool still = mission.sensors[i].odometry == mission.sensors[i - 1].odometry;
        const double before_s = still_s;
        still_s = still ? still_s + dt_s : 0.0;
        if (still_s > kUmbmarkCornerStop_s && before_s <= kUmbmarkCornerStop_s) ++pauses;
    }
    return pauses;
}

TEST(UmbmarkSquares, AreSeparatedByPausesThatNoCornerHas) {
    EXPECT_EQ(pausesOf(simulate(UmbmarkSquares{}, 1)), 2 * kUmbmarkSquaresEachWay + 1);
    EXPECT_EQ(pausesOf(simulate({.speed_m_s = 0.05, .pause_s = 3.0}, 1)), 11);
    EXPECT_EQ(pausesOf(simulate({.side_m = 1.0, .speed_m_s = 1.0}, 1)), 11);
}

TEST(UmbmarkSquares, OfAPerfectRobotAreClosedAndEndAsTheyBegan) {
    const SimulatedMission mission =
        simulate({.diameter_ratio = 1.0, .wheelbase_ratio = 1.0, .unevenness_m_sqrtm = 0.0}, 1);
    EXPECT_NEAR(mission.truth.back().pose.position.x, 0.0, 1e-9);
    EXPECT_NEAR(mission.truth.back().pose.position.y, 0.0, 1e-9);
    EXPECT_NEAR(mission.truth.back().pose.heading_rad, 0.0, 1e-9);
}

TEST(UmbmarkSquares, AreDrivenByOdometryThatThinksItIsRight) {
    const SimulatedMission mission = simulate(UmbmarkSquares{}, 2);
    const auto ticks = std::get<WheelTicks>(mission.sensors.back().odometry);
    EXPECT_LE(std::abs(ticks.left - ticks.right), 1);
    EXPECT_GT(mission.truth.back().pose.position.x * mission.truth.back().pose.position.x +
                  mission.truth.back().pose.position.y * mission.truth.back().pose.position.y,
              0.01);
}

TEST(UmbmarkSquares, TurnTooLittleWhereTheRealWheelbaseIsWider) {
    const SimulatedMission mission =
        simulate({.diameter_ratio = 1.0, .wheelbase_ratio = 1.02, .unevenness_m_sqrtm = 0.0}, 1);
    double least_rad = 0.0;
    for (const TrackPoint& point : mission.truth)
        least_rad = std::min(least_rad, point.pose.heading_rad);
    EXPECT_NEAR(least_rad, -5.0 * 2.0 * kPi / 1.02, 1e-6);  // after five squares clockwise
}

}  // namespace
}  // namespace hedr
