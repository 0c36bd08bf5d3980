// Whatever a robot reports, every estimator of the table goes on with finite numbers.
#include "core/fusion/tracker.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace hedr {
namespace {

constexpr double kStep_s = 0.02;
constexpr double kSpeed_m_s = 0.5;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vehicle vehicleWithEverything() {
    Vehicle vehicle;
    vehicle.geometry = {0.2, 0.2, 0.4, 1000.0};
    vehicle.gyro_drift = {0.001, -0.002, 300.0};
    vehicle.magnetometer = {0.1, -0.1, 0.5, 0.5};
    return vehicle;
}

// A good report of a robot that stands for two seconds, then drives straight on.
SensorReport goodReport(double t_s) {
    constexpr double kTicks_m = 1000.0 / (0.2 * 3.14159265358979);
    const auto ticks = static_cast<std::int64_t>(kTicks_m * kSpeed_m_s * std::max(0.0, t_s - 2.0));
    return {.robot_time_s = t_s,
            .odometry = WheelTicks{ticks, ticks},
            .gyro = GyroRate{-0.002},
            .magnetic_field = MagneticField{0.6, -0.1, 0.3}};
}

double garbage(double good) {
    return *rc::gen::element(good, kNan, kInfinity, -kInfinity, 0.0, -good, 1e308, -1e308, 1e-308,
                             good + 1e3, good - 1e3, good * (1.0 + 1e-15), good + 3600.0, 1e11);
}

std::int64_t garbageTicks(std::int64_t good) {
    constexpr std::int64_t kJump = std::int64_t{1} << 31;
    return *rc::gen::element(good, good + kJump, good - kJump, std::int64_t{0},
                             std::numeric_limits<std::int64_t>::max(),
                             std::numeric_limits<std::int64_t>::min());
}

Odometry garbageOdometry(const Odometry& good) {
    const std::int64_t ticks = std::get<WheelTicks>(good).left;
    switch (*rc::gen::inRange(0, 6)) {
        case 0:
            return WheelTicks{garbageTicks(ticks), garbageTicks(ticks)};
        case 1:
            return WheelTravel{garbage(1.0), garbage(1.0)};
        case 2:
            return PathTravel{garbage(1.0)};
        case 3:
            return OdometryPose{garbage(1.0), garbage(1.0), garbage(1.0)};
        case 4:
            return {};
        default:
            return good;
    }
}

SensorReport garbageReport(const SensorReport& good) {
    SensorReport report = good;
    report.robot_time_s = garbage(good.robot_time_s);
    report.odometry = garbageOdometry(good.odometry);
    switch (*rc::gen::inRange(0, 3)) {
        case 0:
            report.gyro = GyroRate{garbage(0.1)};
            break;
        case 1:
            report.gyro = GyroAngle{*rc::gen::arbitrary<std::uint32_t>()};
            break;
        default:
            report.gyro = {};
    }
    report.magnetic_field = MagneticField{garbage(0.1), garbage(0.1), garbage(0.1)};
    return report;
}

Tracker trackerOfAll() {
    const Vehicle vehicle = vehicleWithEverything();
    Tracker::Setup setup{.vehicle = vehicle, .config = fusionPreset(vehicle)};
    for (const EstimatorEntry& entry : estimatorTable()) setup.estimators.push_back(&entry);
    return Tracker(setup);
}

bool finite(const TrackPoint& point) {
    const PoseVariance& v = point.variance;
    return std::isfinite(point.t_s) && std::isfinite(point.pose.position.x) &&
           std::isfinite(point.pose.position.y) && std::isfinite(point.pose.heading_rad) &&
           std::isfinite(point.gyro_bias_rad_s) && std::isfinite(v.var_x_m2) &&
           std::isfinite(v.cov_xy_m2) && std::isfinite(v.var_y_m2) &&
           std::isfinite(v.var_heading_rad2);
}

std::vector<Point<World>> positionsOf(const Tracker& tracker) {
    std::vector<Point<World>> positions;
    for (std::size_t i = 0; i < tracker.size(); ++i) {
        const TrackPoint point = tracker.point(i);
        RC_ASSERT(finite(point));
        positions.push_back(point.pose.position);
    }
    return positions;
}

RC_GTEST_PROP(BadInput, LeavesEveryTrackFiniteAndLetsItGoOn, ()) {
    Tracker tracker = trackerOfAll();
    const int bad_from = *rc::gen::element(0, 50, 400);
    double last_t_s = -kInfinity;
    for (int i = 0; i < 600; ++i) {
        const SensorReport good = goodReport(kStep_s * i);
        const bool bad = i >= bad_from && i < bad_from + 60 && *rc::gen::inRange(0, 3) == 0;
        if (!tracker.add(bad ? garbageReport(good) : good)) continue;
        positionsOf(tracker);
        RC_ASSERT(tracker.motion().t_s >= last_t_s);
        last_t_s = tracker.motion().t_s;
    }
    // A metre of way in every track; what a filter corrects later may add to it.
    std::vector<double> path_m(tracker.size());
    auto last = positionsOf(tracker);
    for (int i = 600; i < 700; ++i) {
        tracker.add(goodReport(kStep_s * i));
        const auto now = positionsOf(tracker);
        for (std::size_t each = 0; each < now.size(); ++each)
            path_m[each] += (now[each] - last[each]).length();
        last = now;
    }
    for (const double each_m : path_m) RC_ASSERT(each_m > 0.95);
}

TEST(BadInput, IsCounted) {
    Tracker tracker = trackerOfAll();
    for (int i = 0; i < 200; ++i) {
        SensorReport report = goodReport(kStep_s * i);
        if (i == 150) report.gyro = GyroRate{kNan};
        if (i == 160) report.robot_time_s = kInfinity;
        if (i == 170) std::get<WheelTicks>(report.odometry).left += std::int64_t{1} << 31;
        tracker.add(report);
    }
    EXPECT_EQ(tracker.motions().brokenSamples(), 3u);
    EXPECT_EQ(tracker.motions().restarts(), 0u);
    EXPECT_NEAR(tracker.driven_m(), kSpeed_m_s * 1.98, 1e-3);
}

TEST(BadInput, OfHundredsOfRowsCostsNoWay) {
    Tracker tracker = trackerOfAll();
    for (int i = 0; i < 1000; ++i) {
        SensorReport report = goodReport(kStep_s * i);
        if (i >= 300 && i < 700) report.gyro = GyroRate{kNan};
        tracker.add(report);
    }
    EXPECT_EQ(tracker.motions().restarts(), 0u);
    EXPECT_NEAR(tracker.driven_m(), kSpeed_m_s * 17.98, 1e-3);
}

}  // namespace
}  // namespace hedr
