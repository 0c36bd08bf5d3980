#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/calibration/gyro/gyro_bias.h"
#include "core/calibration/gyro/stillness.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

// Of a minute at 50 Hz, with a nudge of so many degrees within 0.3 s after 40 s.
std::vector<SensorReport> standingReports(double nudge_deg) {
    Random random(7);
    std::vector<SensorReport> reports;
    for (double t_s = 0.02; t_s < 60.0; t_s += 0.02) {
        const double rate_deg_s =
            0.5 + 0.1 * random.normal() + (t_s > 40.0 && t_s <= 40.3 ? nudge_deg / 0.3 : 0.0);
        reports.push_back({.robot_time_s = t_s, .gyro = GyroRate{radFromDeg(rate_deg_s)}});
    }
    return reports;
}

std::vector<Unrest> unrestOf(double nudge_deg) {
    const auto reports = standingReports(nudge_deg);
    return stillnessIn(reports, gyroSamplesOf(reports).value(), {}).unrest();
}

double most(const std::vector<Unrest>& unrest) {
    return std::ranges::max(unrest, {}, &Unrest::strength).strength;
}

TEST(Unrest, IsBelowItsLimitWhileItStandsAndAboveWhereItMoves) {
    const auto standing = unrestOf(0.0);
    EXPECT_GT(standing.size(), 100U) << "twice a second";
    EXPECT_GT(most(standing), 0.1);
    EXPECT_LE(most(standing), 1.0);
    EXPECT_GT(most(unrestOf(0.3)), 1.0);
}

TEST(Unrest, GrowsWithWhatIsDoneToTheRobot) {
    EXPECT_LT(most(unrestOf(0.0)), most(unrestOf(0.1)));
    EXPECT_LT(most(unrestOf(0.1)), most(unrestOf(0.3)));
}

TEST(Unrest, IsOnThePageOfABias) {
    const Calibration calibration = calibrateGyroBias(standingReports(0.3), {}).calibration;
    ASSERT_EQ(calibration.plots.size(), 2U);
    const EvidencePlot& meter = calibration.plots[1];
    EXPECT_EQ(meter.title, "Unrest (above 1: it moves)");
    ASSERT_EQ(meter.series.size(), 2U);
    EXPECT_EQ(meter.series[1].y, (std::vector{1.0, 1.0}));
}

}  // namespace
}  // namespace hedr
