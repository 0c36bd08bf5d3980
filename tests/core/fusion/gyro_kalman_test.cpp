#include "core/fusion/gyro_kalman.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "core/fusion/estimators.h"
#include "core/fusion/gyro.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

// The paper's Gyrostar.
constexpr GyroDrift kGyrostar{radFromDeg(0.153), radFromDeg(-0.264), 5.64 * 60.0};
constexpr double kSample_s = 0.03;

double driftAt(const GyroDrift& drift, double t_s) {
    return drift.c1_rad_s * (1.0 - std::exp(-t_s / drift.time_s)) + drift.c2_rad_s;
}

struct HeadingErrors {
    double uncompensated_deg = 0.0;  // the bare gyro
    double standing_bias_deg = 0.0;  // the estimator gyro
    double kalman_deg = 0.0;
    double last_over_expected = 0.0;  // the last one of the Kalman filter, by its own sigma
};

// The largest heading errors of ten minutes with turns at up to 40 degrees per second, after 60 s
// of standing (2,000 samples), the gyro switched on `warm_s` before.
HeadingErrors driveWithAGyrostar(std::uint64_t seed, double warm_s) {
    Vehicle vehicle;
    vehicle.gyro_drift = kGyrostar;
    MotionBuilder motions(vehicle);
    GyroEstimator gyro({}, {}, {});
    GyroKalman kalman({}, fusionPreset(vehicle).gyro_kalman);
    Random random(seed);
    double heading_rad = 0.0;
    double bare_rad = 0.0;
    HeadingErrors worst;
    const auto note = [&](double& error_deg, double estimate_rad) {
        error_deg = std::max(error_deg, std::abs(degFromRad(estimate_rad - heading_rad)));
    };
    for (int i = 0; i * kSample_s < 660.0; ++i) {
        const double t_s = i * kSample_s;
        const bool drives = t_s > 60.0;
        const bool turns = drives && std::fmod(t_s, 30.0) < 4.0;
        const double rate_rad_s =
            turns ? radFromDeg(std::fmod(t_s, 60.0) < 30.0 ? 40.0 : -35.0) : 0;
        const double sensed_rad_s =
            rate_rad_s + driftAt(kGyrostar, warm_s + t_s) + radFromDeg(0.2) * random.normal();
        const auto motion = motions.add({.robot_time_s = t_s,
                                         .odometry = PathTravel{drives ? 0.5 * (t_s - 60.0) : 0.0},
                                         .gyro = GyroRate{sensed_rad_s}});
        if (!motion) continue;
        gyro.update(*motion);
        kalman.update(*motion);
        if (!drives) continue;
        heading_rad += rate_rad_s * kSample_s;
        bare_rad += sensed_rad_s * kSample_s;
        note(worst.uncompensated_deg, bare_rad);
        note(worst.standing_bias_deg, gyro.pose().heading_rad);
        note(worst.kalman_deg, kalman.pose().heading_rad);
    }
    worst.last_over_expected =
        (kalman.pose().heading_rad - heading_rad) / std::sqrt(kalman.covariance()(2, 2));
    return worst;
}

TEST(GyroKalman, HoldsTenMinutesWithAGyrostarToFiveDegreesAsThePaperDoes) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        for (const double warm_s : {0.0, 300.0}) {
            const HeadingErrors errors = driveWithAGyrostar(seed, warm_s);
            EXPECT_GT(errors.uncompensated_deg, 50.0);
            EXPECT_LT(errors.kalman_deg, 5.0) << seed;
            EXPECT_GT(errors.uncompensated_deg / errors.kalman_deg, 7.0) << seed;
        }
    }
}

TEST(GyroKalman, IsOffByWhatItSays) {
    double squares = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        squares += std::pow(driveWithAGyrostar(seed, 100.0).last_over_expected, 2);
    }
    const double rms = std::sqrt(squares / 20.0);
    std::cout << "heading: " << rms << " of the expected error\n";
    EXPECT_GT(rms, 1.0 / 3.0);
    EXPECT_LT(rms, 3.0);
}

TEST(GyroKalman, KnowsMoreThanTheBiasOfTheStart) {
    const HeadingErrors errors = driveWithAGyrostar(1, 0.0);
    EXPECT_GT(errors.standing_bias_deg / errors.kalman_deg, 5.0);
}

Motion turning(double dt_s, double rate_rad_s) {
    return {.dt_s = dt_s, .odometry_turn_rad = 0.0, .gyro_turn_rad = rate_rad_s * dt_s};
}

TEST(GyroKalman, FollowsTheCurveFromSwitchOnWhereNoBiasWasMeasured) {
    GyroKalman filter({}, {.drift = kGyrostar});
    for (int i = 1; i <= 20000; ++i)
        filter.update(turning(kSample_s, driftAt(kGyrostar, i * kSample_s)));
    EXPECT_NEAR(filter.gyro_bias_rad_s(), driftAt(kGyrostar, 600.0), 1e-9);
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad), 0.0, 0.01);
}

TEST(GyroKalman, KeepsAnOffsetThatItsCurveCannotExplain) {
    const double offset_rad_s = radFromDeg(-0.1);
    GyroKalman filter({},
                      {.drift = kGyrostar, .known_bias_rad_s = kGyrostar.c2_rad_s + offset_rad_s});
    for (int i = 1; i <= 20000; ++i) {
        filter.update(turning(kSample_s, driftAt(kGyrostar, i * kSample_s) + offset_rad_s));
    }
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad), 0.0, 0.01);
}

// White noise of the standing average, 0.0045 degrees per second here, would turn 3 degrees in ten
// minutes if it were believed to stay.
TEST(GyroKalman, TakesTheNoiseOfTheStandingBiasForNoOffset) {
    GyroKalman filter({}, {.drift = kGyrostar});
    const double mean_rad_s = driftAt(kGyrostar, 29.0) - radFromDeg(0.0045);  // over a minute
    for (int i = 1; i <= 22000; ++i) {
        const double t_s = i * kSample_s;
        Motion motion = turning(kSample_s, driftAt(kGyrostar, t_s) - mean_rad_s);
        motion.gyro_bias_rad_s = mean_rad_s;
        motion.bias_measured_s = std::min(t_s, 60.0);
        filter.update(motion);
    }
    EXPECT_LT(std::abs(degFromRad(filter.pose().heading_rad)), 1.0);
}

TEST(GyroKalman, AMeasuredBiasOfZeroIsAMeasurement) {
    GyroKalman filter({}, {.drift = kGyrostar});
    Motion standing = turning(10.0, 0.0);
    standing.bias_measured_s = 10.0;
    filter.update(standing);
    EXPECT_NEAR(filter.gyro_bias_rad_s(), 0.0, radFromDeg(0.05));
}

// Eq. (3) is the first order of the steps that are taken here.
TEST(GyroKalman, ItsStepsAreThoseOfEquation3) {
    const double share = kGyrostar.time_s / (kGyrostar.time_s + kSample_s);
    const double warm_rad_s = kGyrostar.c1_rad_s + kGyrostar.c2_rad_s;
    double bias_rad_s = kGyrostar.c2_rad_s;
    GyroKalman filter({}, {.drift = kGyrostar});
    for (int i = 0; i < 10000; ++i) {
        bias_rad_s = share * bias_rad_s + (1.0 - share) * warm_rad_s;
        filter.update(turning(kSample_s, 0.0));
    }
    EXPECT_NEAR(filter.gyro_bias_rad_s(), bias_rad_s, radFromDeg(1e-4));
}

// The last element of Eq. (6) as printed forgets the bias in one step.
TEST(GyroKalman, ThePrintedLastElementOfEquation6ForgetsTheBiasAtOnce) {
    const double printed = kSample_s / (kGyrostar.time_s + kSample_s);
    EXPECT_LT(std::abs(printed * kGyrostar.c2_rad_s), 1e-4 * std::abs(kGyrostar.c2_rad_s));
    GyroKalman filter({}, {.drift = kGyrostar});
    filter.update(turning(kSample_s, 0.0));
    EXPECT_NEAR(filter.gyro_bias_rad_s(), kGyrostar.c2_rad_s, radFromDeg(1e-4));
}

// Row 5 of Eq. (6) as printed lets the angle's error grow T_1 times too slowly: the drift stays in.
TEST(GyroKalman, ThePrintedRow5OfEquation6LeavesTheDriftInTheHeading) {
    double sensed_rad = 0.0;
    double printed_error_rad = 0.0;
    GyroKalman filter({}, {.drift = kGyrostar});
    for (int i = 1; i <= 20000; ++i) {
        const double bias_rad_s = driftAt(kGyrostar, i * kSample_s);
        sensed_rad += bias_rad_s * kSample_s;
        printed_error_rad += bias_rad_s * kSample_s / kGyrostar.time_s;
        filter.update(turning(kSample_s, bias_rad_s));
    }
    EXPECT_GT(std::abs(degFromRad(sensed_rad - printed_error_rad)), 90.0);
    EXPECT_LT(std::abs(degFromRad(filter.pose().heading_rad)), 0.01);
}

// One rate, integrated or not, holds no hint at what of it is drift.
TEST(GyroKalman, CannotTellDriftFromTurning) {
    GyroKalman filter({}, {.drift = kGyrostar});
    const double unknown_rad_s = radFromDeg(0.05);
    for (int i = 1; i <= 10000; ++i) {
        filter.update(turning(kSample_s, driftAt(kGyrostar, i * kSample_s) + unknown_rad_s));
    }
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad), 0.05 * 300.0, 0.05);
}

double worstErrorOfAQuickTurn_deg(const GyroKalmanConfig& config) {
    GyroKalman filter({}, config);
    double turned_deg = 0.0;
    double worst_deg = 0.0;
    for (int i = 0; i < 500; ++i) {
        const double rate_deg_s = i >= 100 && i < 150 ? 60.0 : 0.0;
        turned_deg += rate_deg_s * kSample_s;
        filter.update(turning(kSample_s, radFromDeg(rate_deg_s)));
        worst_deg =
            std::max(worst_deg, std::abs(degFromRad(filter.pose().heading_rad) - turned_deg));
    }
    return worst_deg;
}

TEST(GyroKalman, FollowsQuickTurnsWhichThePapersSigmaDoesNot) {
    EXPECT_LT(worstErrorOfAQuickTurn_deg({}), 1.0);
    EXPECT_GT(worstErrorOfAQuickTurn_deg({.jerk_walk_rad_s3_sqrts = radFromDeg(0.05)}), 10.0);
}

TEST(GyroKalman, TurnsOverAGapAsTheMotionSays) {
    GyroKalman filter({}, {.drift = kGyrostar});
    filter.update(turning(kSample_s, driftAt(kGyrostar, 0.0)));
    filter.update({.dt_s = 3600.0, .odometry_turn_rad = 0.5, .gyro_turn_rad = 0.5});
    EXPECT_NEAR(filter.pose().heading_rad, 0.5, 1e-4);
    const double warm_rad_s = kGyrostar.c1_rad_s + kGyrostar.c2_rad_s;
    EXPECT_NEAR(filter.gyro_bias_rad_s(), warm_rad_s, radFromDeg(1e-4));
    for (int i = 0; i < 100; ++i) filter.update(turning(kSample_s, warm_rad_s));
    EXPECT_NEAR(filter.pose().heading_rad, 0.5, 1e-4);
}

TEST(GyroKalman, StaysFiniteForHours) {
    GyroKalman filter({}, {.drift = {0.0, 0.0, 300.0}});
    for (int i = 1; i <= 50 * 7200; ++i) {
        filter.update({.t_s = 0.02 * i,
                       .dt_s = 0.02,
                       .distance_m = 0.01,
                       .gyro_turn_rad = 0.006 * std::sin(0.001 * i)});
        ASSERT_TRUE(std::isfinite(filter.pose().heading_rad)) << 0.02 * i << " s";
    }
    EXPECT_GT(filter.covariance()(2, 2), 0.0);
}

// A log that pauses for nearly two seconds between steps of a microsecond.
TEST(GyroKalman, BearsLongAndShortStepsInTurn) {
    GyroKalman filter({}, {});
    for (int i = 0; i < 200; ++i) {
        const double dt_s = i % 2 == 0 ? 1e-6 : 1.9;
        filter.update({.t_s = 1.0 * i, .dt_s = dt_s, .gyro_turn_rad = 0.01 * dt_s});
        ASSERT_TRUE(std::isfinite(filter.pose().heading_rad)) << i;
        ASSERT_GE(filter.covariance()(2, 2), 0.0) << i;
    }
}

}  // namespace
}  // namespace hedr
