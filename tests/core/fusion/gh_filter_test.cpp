#include "core/fusion/gh_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

constexpr double kSample_s = 0.01;

// What an undisturbed magnetometer with this centre and half range shows at a heading.
MagneticField fieldAt(double heading_rad, const MagnetometerRange& range = {}) {
    return {range.centre_x + range.range_x * std::cos(heading_rad),
            range.centre_y - range.range_y * std::sin(heading_rad), -40.0};
}

Motion turned(double wheels_rad, double gyro_rad, double dt_s = kSample_s) {
    return {.dt_s = dt_s, .odometry_turn_rad = wheels_rad, .gyro_turn_rad = gyro_rad};
}

Motion turnedTo(double heading_rad, double wheels_rad, const MagnetometerRange& range = {}) {
    Motion motion = turned(wheels_rad, wheels_rad);
    motion.magnetic_field = fieldAt(heading_rad, range);
    return motion;
}

// A field is seen, then the wheels move.
void setOff(GhFilter& filter, double heading_rad, const MagnetometerRange& range = {}) {
    Motion motion = turnedTo(heading_rad, 0.0, range);
    filter.update(motion);
    motion.distance_m = 0.01;
    filter.update(motion);
}

TEST(GhFilter, TheGyroCorrectsWheelsThatSlip) {
    GhFilter filter({}, GhHeading::kGyro, {});
    for (int i = 0; i < 100; ++i) filter.update(turned(0.02, 0.01));
    for (int i = 0; i < 100; ++i) filter.update(turned(0.0, 0.0));
    EXPECT_NEAR(filter.pose().heading_rad, 1.0, 1e-9);
}

TEST(GhFilter, ItsGainsMeanTheSameAtEverySamplingRate) {
    for (const double dt_s : {0.005, 0.01, 0.02, 0.05}) {
        GhFilter filter({}, GhHeading::kGyro, {.alpha = 0.1, .beta = 0.3});
        filter.update(turned(0.0, 0.0, dt_s));
        filter.update(turned(0.0, 0.2, 1e-9));  // the gyro alone has turned
        for (int i = 0; i < static_cast<int>(std::lround(0.1 / dt_s)); ++i) {
            filter.update(turned(0.0, 0.0, dt_s));
        }
        EXPECT_NEAR(filter.pose().heading_rad, 0.2 * (1.0 - std::pow(0.9, 10)), 1e-6) << dt_s;
    }
}

// Eq. (5) as printed adds the wheels' rate again and again.
TEST(GhFilter, PrintedEquation5GrowsWithoutBound) {
    double printed_rad_s = 0.0;
    for (int i = 0; i < 1000; ++i) printed_rad_s += 0.3 * 1.0;
    EXPECT_GT(printed_rad_s, 100.0);
    GhFilter filter({}, GhHeading::kGyro, {});
    for (int i = 0; i < 1000; ++i) filter.update(turned(kSample_s, kSample_s));
    EXPECT_NEAR(filter.pose().heading_rad, 10.0, 0.01);
}

// Eq. (6) as printed takes a share of the sensed heading away from the heading, at every sample.
TEST(GhFilter, PrintedEquation6RunsAwayWhileTheRobotDrivesStraight) {
    double printed_rad = 1.0;
    for (int i = 0; i < 1000; ++i) printed_rad += 0.2 * (0.0 - 1.0);
    EXPECT_LT(printed_rad, -100.0);
    GhFilter filter({{}, 1.0}, GhHeading::kGyro, {});
    for (int i = 0; i < 1000; ++i) filter.update(turned(0.0, 0.0));
    EXPECT_EQ(filter.pose().heading_rad, 1.0);
}

// Eq. (7) as printed knows half a circle only.
TEST(GhFilter, TheMagnetometerTellsAllDirections) {
    EXPECT_NEAR(std::atan(-0.5 / -0.5), std::atan(0.5 / 0.5), 1e-12);
    GhFilter filter({}, GhHeading::kMagnetometer, {});
    setOff(filter, 0.0);
    for (int i = 1; i <= 628; ++i) {
        filter.update(turnedTo(0.01 * i, 0.0));  // the wheels see nothing of it
        ASSERT_NEAR(filter.pose().heading_rad, 0.01 * i, 0.05) << i;
    }
}

// Eq. (8) as printed finds the middle of 179 and -179 degrees at zero.
TEST(GhFilter, BlendsOnTheCircle) {
    const double start_rad = radFromDeg(179.0);
    GhFilter filter({{}, start_rad}, GhHeading::kCombined, {.gamma = 0.5});
    setOff(filter, start_rad);
    for (int i = 1; i <= 300; ++i) {
        filter.update(turnedTo(start_rad + radFromDeg(0.01 * i), radFromDeg(0.01)));
    }
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad), 182.0, 0.05);
}

TEST(GhFilter, CorrectsCentreRangeAndMountingOfTheMagnetometer) {
    const MagnetometerRange range{3.5, -1.2, 0.4, -0.6};
    GhFilter filter({}, GhHeading::kMagnetometer, {.magnetometer = range});
    setOff(filter, 0.0, range);
    for (int i = 0; i < 1000; ++i) filter.update(turnedTo(2.0, 0.0, range));
    EXPECT_NEAR(filter.pose().heading_rad, 2.0, 1e-6);
}

// The ellipse of that field lies askew: as soft iron makes it of the circle.
TEST(GhFilter, CorrectsAnEllipseThatLiesAskew) {
    const MagnetometerRange range{3.5, -1.2, 0.4, 0.6, 0.3};
    const auto askew = [&](double heading_rad) {
        Motion motion = turnedTo(heading_rad, 0.0, range);
        motion.magnetic_field->y =
            range.centre_y +
            range.range_y * (0.3 * std::cos(heading_rad) - std::sqrt(0.91) * std::sin(heading_rad));
        return motion;
    };
    GhFilter filter({}, GhHeading::kMagnetometer, {.magnetometer = range});
    Motion start = askew(0.0);
    filter.update(start);
    start.distance_m = 0.01;
    filter.update(start);
    for (int i = 0; i < 1000; ++i) filter.update(askew(2.0));
    EXPECT_NEAR(filter.pose().heading_rad, 2.0, 1e-6);
}

TEST(GhFilter, TakesTheMeanOfTheStandingStartForItsHeading) {
    Random random(5);
    GhFilter filter({{}, 0.7}, GhHeading::kMagnetometer, {});
    const double north_rad = 2.1;
    const auto noisy = [&] { return north_rad + radFromDeg(5.0) * random.normal(); };
    for (int i = 0; i < 1000; ++i) filter.update(turnedTo(noisy(), 0.0));
    setOff(filter, noisy());
    double mean_rad = 0.0;
    for (int i = 0; i < 1000; ++i) {
        filter.update(turnedTo(noisy(), 0.0));
        mean_rad += filter.pose().heading_rad / 1000.0;
    }
    EXPECT_NEAR(mean_rad, 0.7, radFromDeg(0.6));
}

TEST(GhFilter, ARareFieldWeighsAsMuchAsAFrequentOne) {
    const auto headingAfter = [](int every) {
        GhFilter filter({}, GhHeading::kMagnetometer, {.alpha = 0.02});
        setOff(filter, 0.0);
        for (int i = 1; i <= 100; ++i) {
            filter.update(i % every == 0 ? turnedTo(0.5, 0.0) : turned(0.0, 0.0));
        }
        return filter.pose().heading_rad;
    };
    EXPECT_NEAR(headingAfter(10), headingAfter(1), 1e-6);
}

TEST(GhFilter, GoesOnByTheWheelsWhileTheFieldIsMissing) {
    for (const auto heading : {GhHeading::kMagnetometer, GhHeading::kCombined}) {
        GhFilter filter({}, heading, {});
        for (int i = 0; i < 100; ++i) filter.update(turned(0.01, 0.01));
        EXPECT_NEAR(filter.pose().heading_rad, 1.0, 0.05);
        Motion useless = turned(0.0, 0.0);
        useless.magnetic_field = {0.0, 0.0, 1.0};  // points nowhere
        filter.update(useless);
        EXPECT_TRUE(std::isfinite(filter.pose().heading_rad));
    }
}

}  // namespace
}  // namespace hedr
