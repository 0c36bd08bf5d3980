#include "core/simulation/sensor_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedr {
namespace {

constexpr VehicleGeometry kGeometry{0.2, 0.2, 0.5, 100.0};
constexpr SensorErrors kPerfect{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

std::vector<Pose<World>> arc(double speed_m_s, double rate_rad_s, std::size_t samples) {
    std::vector<Pose<World>> poses(1);
    while (poses.size() < samples) {
        const Pose<World>& p = poses.back();
        const double middle = p.heading_rad + 0.5 * rate_rad_s / 50.0;
        poses.push_back({p.position + Vector<World>{speed_m_s / 50.0 * std::cos(middle),
                                                    speed_m_s / 50.0 * std::sin(middle)},
                         p.heading_rad + rate_rad_s / 50.0});
    }
    return poses;
}

WheelTicks ticks(const SensorReport& report) { return std::get<WheelTicks>(report.odometry); }
double rate(const SensorReport& report) { return std::get<GyroRate>(report.gyro).rad_s; }

TEST(SensorReports, CountAPerfectRobotsTravelExactly) {
    Random random(1);
    const auto reports = sensorReports(arc(0.6, 0.0, 501), 50.0, kGeometry, kPerfect, random);
    const auto expected = static_cast<std::int64_t>(6.0 / (0.2 * kPi) * 100.0);
    EXPECT_EQ(ticks(reports.back()).left, expected);
    EXPECT_EQ(ticks(reports.back()).right, expected);
}

TEST(SensorReports, ShareATurnBetweenTheTracks) {
    Random random(1);
    const auto reports = sensorReports(arc(0.0, 0.4, 501), 50.0, kGeometry, kPerfect, random);
    const double per_track_m = 0.5 * 0.5 * 0.4 * 10.0;
    const auto expected = static_cast<std::int64_t>(per_track_m / (0.2 * kPi) * 100.0);
    EXPECT_NEAR(static_cast<double>(ticks(reports.back()).right), static_cast<double>(expected), 1);
    EXPECT_NEAR(static_cast<double>(ticks(reports.back()).left), -static_cast<double>(expected), 1);
    EXPECT_NEAR(rate(reports.back()), 0.4, 1e-9);
}

TEST(SensorReports, CountBackwardsWhenTheRobotReverses) {
    Random random(1);
    const auto reports = sensorReports(arc(-0.6, 0.0, 101), 50.0, kGeometry, kPerfect, random);
    EXPECT_LT(ticks(reports.back()).left, -180);
}

TEST(SensorReports, GiveTheGyroItsAngleRandomWalk) {
    SensorErrors errors = kPerfect;
    errors.gyro_noise_rad_s_sqrthz = 0.01;
    Random random(5);
    const auto reports = sensorReports(arc(0.0, 0.0, 100001), 50.0, kGeometry, errors, random);
    double squares = 0.0;
    for (const SensorReport& report : reports) squares += rate(report) * rate(report);
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(reports.size())), 0.01 * std::sqrt(50.0),
                0.001);
}

TEST(SensorReports, LetTheBiasWalkByTheRootOfTime) {
    SensorErrors errors = kPerfect;
    errors.gyro_bias_walk_rad_s_sqrts = 0.001;
    double squares = 0.0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        Random random(seed);
        const auto reports = sensorReports(arc(0.0, 0.0, 5001), 50.0, kGeometry, errors, random);
        squares += rate(reports.back()) * rate(reports.back());
    }
    EXPECT_NEAR(std::sqrt(squares / 400.0), 0.001 * std::sqrt(100.0), 0.001);
}

TEST(SensorReports, DrawAStartBiasWithinItsLimits) {
    SensorErrors errors = kPerfect;
    errors.gyro_bias_rad_s = 0.01;
    double largest = 0.0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Random random(seed);
        const auto reports = sensorReports(arc(0.0, 0.0, 1), 50.0, kGeometry, errors, random);
        largest = std::max(largest, std::abs(rate(reports.front())));
    }
    EXPECT_LE(largest, 0.01);
    EXPECT_GT(largest, 0.009);
}

}  // namespace
}  // namespace hedr
