// What the estimators say of their errors, beside the errors that they make.
#include "core/fusion/pose_covariance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string_view>

#include "core/fusion/tracker.h"
#include "core/simulation/scenario.h"

namespace hedr {
namespace {

TEST(PoseCovariance, AHeadingErrorMovesTheEndOfTheWaySideways) {
    PoseCovariance covariance;
    covariance.move({}, {.turn_rad2 = 0.01});
    covariance.move({3.0, 4.0}, {});
    const Eigen::Matrix3d p = covariance.matrix();
    EXPECT_NEAR(p(0, 0), 0.01 * 16.0, 1e-12);
    EXPECT_NEAR(p(0, 1), -0.01 * 12.0, 1e-12);
    EXPECT_NEAR(p(1, 1), 0.01 * 9.0, 1e-12);
    EXPECT_NEAR(p(2, 2), 0.01, 1e-12);
    EXPECT_NEAR(p(1, 2), 0.01 * 3.0, 1e-12);
}

TEST(PoseCovariance, AnUnknownDriftGrowsWithTheSquareOfTime) {
    PoseCovariance covariance(1e-4);
    for (int i = 0; i < 100; ++i) covariance.move({}, {.drift_share = 0.1});
    EXPECT_NEAR(covariance.heading_rad2(), 1e-4 * 100.0, 1e-12);
}

TEST(PoseCovariance, SlipLiesAlongTheWay) {
    PoseCovariance covariance;
    covariance.move({0.0, 2.0}, {.along_m2 = 0.5});
    EXPECT_NEAR(covariance.matrix()(0, 0), 0.0, 1e-12);
    EXPECT_NEAR(covariance.matrix()(1, 1), 0.5, 1e-12);
}

// Mean squares of errors over what was expected of them: 1 where the estimator knows itself.
struct Normalised {
    double heading = 0.0;
    double position = 0.0;
    int count = 0;
};

void judge(const SimulatedMission& mission, std::string_view estimator, Normalised& sum) {
    Tracker tracker({.vehicle = mission.vehicle,
                     .config = fusionPreset(mission.vehicle),
                     .start = mission.start,
                     .estimators = {findEstimator(estimator)}});
    std::size_t next = 0;
    int steps = 0;
    for (const SensorReport& report : mission.sensors) {
        if (!tracker.add(report) || ++steps % 5000 != 0) continue;
        const TrackPoint point = tracker.point(0);
        while (mission.truth[next].t_s < point.t_s - 1e-6) ++next;
        const Pose<World>& truth = mission.truth[next].pose;
        const PoseVariance& v = point.variance;
        sum.heading += std::pow(point.pose.heading_rad - truth.heading_rad, 2) /
                       static_cast<double>(v.var_heading_rad2);
        sum.position += std::pow((point.pose.position - truth.position).length(), 2) /
                        static_cast<double>(v.var_x_m2 + v.var_y_m2);
        ++sum.count;
    }
}

class HonestEstimator : public ::testing::TestWithParam<const char*> {};

TEST_P(HonestEstimator, IsOffByWhatItSaysInCorridors) {
    Normalised sum;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        judge(simulate(scenarioByName("packbot-corridors").value(), seed), GetParam(), sum);
    }
    const double heading = std::sqrt(sum.heading / sum.count);
    const double position = std::sqrt(sum.position / sum.count);
    std::cout << GetParam() << ": heading " << heading << ", position " << position
              << " of the expected error\n";
    EXPECT_GT(heading, 1.0 / 3.0);
    EXPECT_LT(heading, 3.0);
    EXPECT_GT(position, 1.0 / 3.0);
    EXPECT_LT(position, 3.0);
}

INSTANTIATE_TEST_SUITE_P(All, HonestEstimator,
                         ::testing::Values("odometry", "gyro", "gyrodometry", "gh_gyro"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace hedr
