#include "core/robot/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// One tick is a millimetre; wheels half a metre apart.
Vehicle millimetreVehicle(int counter_bits = 32) {
    Vehicle vehicle;
    vehicle.geometry = {1.0 / kPi, 1.0 / kPi, 0.5, 1000.0};
    vehicle.encoder_counter_bits = counter_bits;
    return vehicle;
}

SensorReport ticksAt(double t_s, std::int64_t left, std::int64_t right) {
    return {.robot_time_s = t_s, .odometry = WheelTicks{left, right}};
}

SensorReport turningAt(double t_s, std::int64_t ticks, double rate_rad_s) {
    return {
        .robot_time_s = t_s, .odometry = WheelTicks{ticks, ticks}, .gyro = GyroRate{rate_rad_s}};
}

TEST(MotionBuilder, TurnsCountsIntoDistanceAndTurn) {
    MotionBuilder motions(millimetreVehicle());
    EXPECT_FALSE(motions.add(ticksAt(10.0, 100, 200)));
    const auto motion = motions.add(ticksAt(10.1, 200, 350));
    ASSERT_TRUE(motion);
    EXPECT_DOUBLE_EQ(motion->t_s, 10.1);
    EXPECT_NEAR(motion->distance_m, 0.125, 1e-12);
    EXPECT_NEAR(motion->odometry_turn_rad.value(), 0.05 / 0.5, 1e-12);
    EXPECT_FALSE(motion->gyro_turn_rad);
}

TEST(MotionBuilder, FollowsCountersOverTheirWrap) {
    MotionBuilder motions(millimetreVehicle(16));
    motions.add(ticksAt(0.0, 65530, 6));
    const auto motion = motions.add(ticksAt(0.1, 4, 65532));
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->distance_m, 0.0, 1e-12);
    EXPECT_NEAR(motion->odometry_turn_rad.value(), -0.02 / 0.5, 1e-12);
}

TEST(MotionBuilder, FollowsTheRobotsClockOverItsWrap) {
    MotionBuilder motions(millimetreVehicle(), 100.0);
    motions.add(ticksAt(49.9, 0, 0));
    EXPECT_DOUBLE_EQ(motions.add(ticksAt(50.4, 0, 0))->t_s, 50.4);
    for (const double t_s : {60.0, 70.0, 80.0, 90.0, 99.0}) motions.add(ticksAt(t_s, 0, 0));
    const auto motion = motions.add(ticksAt(0.5, 100, 100));
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->dt_s, 1.5, 1e-9);
    EXPECT_NEAR(motion->t_s, 100.5, 1e-9);
    EXPECT_EQ(motions.restarts(), 0u);
}

TEST(MotionBuilder, StartsAfreshWhereItIsWhenTimeGoesBack) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(100.0, 5000, 5000));
    motions.add(ticksAt(100.1, 5010, 5010));
    EXPECT_FALSE(motions.add(ticksAt(0.0, 0, 0)));
    const auto motion = motions.add(ticksAt(0.1, 10, 10));
    ASSERT_TRUE(motion);
    EXPECT_EQ(motions.restarts(), 1u);
    EXPECT_NEAR(motion->t_s, 100.2, 1e-9);
    EXPECT_NEAR(motion->distance_m, 0.01, 1e-12);
}

TEST(MotionBuilder, DropsAWildSampleAndKeepsTheDistance) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(0.0, 0, 0));
    EXPECT_FALSE(motions.add(ticksAt(0.1, 9'000'000, -40)));
    const auto motion = motions.add(ticksAt(0.2, 100, 100));
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->distance_m, 0.1, 1e-12);
    EXPECT_EQ(motions.brokenSamples(), 1u);
}

TEST(MotionBuilder, TakesSeveralWildSamplesForARestart) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(0.0, 9'000'000, 9'000'000));
    double driven_m = 0.0;
    for (int i = 1; i < 20; ++i) {
        const auto motion = motions.add(ticksAt(0.1 * i, 10 * i, 10 * i));
        if (motion) driven_m += motion->distance_m;
    }
    EXPECT_EQ(motions.restarts(), 1u);
    EXPECT_NEAR(driven_m, 0.15, 1e-9);
}

// The counters start afresh, the clock does not: what follows keeps its times.
TEST(MotionBuilder, KeepsTheTimeOverARestartOfTheCounters) {
    MotionBuilder motions(millimetreVehicle());
    for (int i = 0; i <= 10; ++i) motions.add(ticksAt(0.1 * i, 9'000'000, 9'000'000));
    for (int i = 11; i < 30; ++i) motions.add(ticksAt(0.1 * i, 10 * i, 10 * i));
    EXPECT_EQ(motions.restarts(), 1u);
    EXPECT_NEAR(motions.add(ticksAt(3.0, 300, 300))->t_s, 3.0, 1e-9);
}

TEST(MotionBuilder, BridgesMissingWheelValues) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(turningAt(0.0, 0, 0.0));
    SensorReport gyro_only{.robot_time_s = 0.1, .gyro = GyroRate{0.2}};
    const auto between = motions.add(gyro_only);
    ASSERT_TRUE(between);
    EXPECT_DOUBLE_EQ(between->distance_m, 0.0);
    EXPECT_NEAR(between->gyro_turn_rad.value(), 0.02, 1e-12);
    EXPECT_NEAR(motions.add(turningAt(0.2, 100, 0.0))->distance_m, 0.1, 1e-12);
}

TEST(MotionBuilder, LosesNoHeadingWithALostCumulativeAngle) {
    MotionBuilder motions(millimetreVehicle());
    const auto at = [](double t_s, std::uint32_t urad) {
        return SensorReport{.robot_time_s = t_s, .odometry = WheelTicks{}, .gyro = GyroAngle{urad}};
    };
    motions.add(at(0.0, 4'294'967'000u));
    const auto motion = motions.add(at(0.5, 199'704u));  // 200,000 urad on, over the wrap
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->gyro_turn_rad.value(), 0.2, 1e-9);
}

TEST(MotionBuilder, MeasuresTheBiasWhileStandingAtTheStart) {
    MotionBuilder motions(millimetreVehicle());
    double turned_rad = 0.0;
    for (int i = 0; i <= 100; ++i) motions.add(turningAt(0.02 * i, 0, 0.01));
    for (int i = 101; i <= 200; ++i) {
        turned_rad += motions.add(turningAt(0.02 * i, 12 * (i - 100), 0.01))->gyro_turn_rad.value();
    }
    EXPECT_NEAR(turned_rad, 0.0, 1e-9);
    EXPECT_NEAR(motions.add(turningAt(4.02, 1212, 0.01))->bias_measured_s, 1.56, 0.2);
}

// With coarse encoders it has begun to turn before the first count comes.
TEST(MotionBuilder, LeavesTheLastMomentBeforeItMovesOutOfTheBias) {
    MotionBuilder motions(millimetreVehicle());
    for (int i = 0; i <= 200; ++i) motions.add(turningAt(0.02 * i, 0, i > 188 ? 0.07 : 0.01));
    EXPECT_NEAR(motions.add(turningAt(4.02, 12, 0.07))->gyro_bias_rad_s, 0.01, 1e-12);
}

// Nobody heard the gyro for a minute: it says nothing of the bias.
TEST(MotionBuilder, LeavesAGapOutOfTheBias) {
    MotionBuilder motions(millimetreVehicle());
    for (int i = 0; i <= 10; ++i) motions.add(turningAt(0.1 * i, 0, 0.01));
    for (int i = 0; i <= 100; ++i) motions.add(turningAt(60.0 + 0.1 * i, 0, 0.01));
    EXPECT_NEAR(motions.add(turningAt(70.1, 12, 0.01))->gyro_bias_rad_s, 0.01, 1e-9);
}

// Wheels once a second, the gyro fifty times: between two reports of the wheels it may have moved.
TEST(MotionBuilder, DoesNotTakeSlowWheelReportsForStanding) {
    MotionBuilder motions(millimetreVehicle());
    double turned_rad = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const bool moving = i > 500;
        SensorReport report{.robot_time_s = 0.02 * i, .gyro = GyroRate{moving ? 0.06 : 0.01}};
        const std::int64_t ticks = moving ? 20 * (i - 500) / 50 : 0;
        if (i % 50 == 0) report.odometry = WheelTicks{-ticks, ticks};
        const auto motion = motions.add(report);
        if (!moving || !motion) continue;
        EXPECT_FALSE(motion->standing && i > 550);
        turned_rad += motion->gyro_turn_rad.value();
    }
    EXPECT_NEAR(turned_rad, 0.5, 0.01);
}

TEST(MotionBuilder, MeasuresALargeBias) {
    MotionBuilder motions(millimetreVehicle());
    for (int i = 0; i <= 200; ++i) motions.add(turningAt(0.02 * i, 0, radFromDeg(12.0)));
    EXPECT_NEAR(motions.add(turningAt(4.02, 12, 0.2))->gyro_bias_rad_s, radFromDeg(12.0), 1e-9);
}

TEST(MotionBuilder, PassesOnAMagneticFieldThatIsFinite) {
    MotionBuilder motions(millimetreVehicle());
    const auto fieldOf = [&](double t_s, const std::optional<MagneticField>& field) {
        return motions.add({.robot_time_s = t_s, .magnetic_field = field})->magnetic_field;
    };
    motions.add({.robot_time_s = 0.0});
    EXPECT_EQ(fieldOf(0.1, MagneticField{1.0, 2.0, 3.0}), (MagneticField{1.0, 2.0, 3.0}));
    EXPECT_FALSE(fieldOf(0.2, std::nullopt));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(fieldOf(0.3, MagneticField{1.0, nan, 3.0}));
    EXPECT_EQ(motions.brokenSamples(), 0u);
}

TEST(MotionBuilder, BridgesRowsWithoutAGyroValue) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(turningAt(0.0, 10, 0.2));
    motions.add(turningAt(0.1, 20, 0.2));
    EXPECT_NEAR(motions.add(ticksAt(0.2, 30, 30))->gyro_turn_rad.value(), 0.02, 1e-12);
    const auto silent = motions.add(ticksAt(2.5, 40, 60));  // too long ago
    EXPECT_TRUE(silent->gyro_silent);
    EXPECT_DOUBLE_EQ(silent->gyro_turn_rad.value(), silent->odometry_turn_rad.value());
}

TEST(MotionBuilder, TakesNoNanForAStart) {
    MotionBuilder motions(millimetreVehicle());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    motions.add({.robot_time_s = 0.0, .odometry = WheelTravel{nan, 0.0}});
    EXPECT_FALSE(motions.started());
    motions.add({.robot_time_s = 0.1, .odometry = WheelTravel{5.0, 5.0}});
    const auto motion = motions.add({.robot_time_s = 0.2, .odometry = WheelTravel{5.1, 5.1}});
    EXPECT_NEAR(motion->distance_m, 0.1, 1e-12);
    EXPECT_EQ(motions.brokenSamples(), 1u);
}

TEST(MotionBuilder, LeavesOutAStepOfADayAndBelievesTheThird) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(0.0, 0, 0));
    motions.add(ticksAt(0.1, 10, 10));
    EXPECT_FALSE(motions.add(ticksAt(1e6, 20, 20)));
    EXPECT_NEAR(motions.add(ticksAt(0.2, 30, 30))->t_s, 0.2, 1e-12);
    for (int i = 0; i < 4; ++i) motions.add(ticksAt(1e6 + 0.1 * i, 40, 40));
    EXPECT_NEAR(motions.add(ticksAt(1e6 + 0.4, 50, 50))->t_s, 0.3, 1e-6);
    EXPECT_EQ(motions.restarts(), 1u);
}

TEST(MotionBuilder, CountsFromTheEndOfTheRangeOfItsCounters) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(0.0, std::numeric_limits<std::int64_t>::max(), 0));
    const auto motion = motions.add(ticksAt(0.1, std::numeric_limits<std::int64_t>::min(), 1));
    EXPECT_NEAR(motion->distance_m, 1e-3, 1e-9);
}

TEST(MotionBuilder, KnowsThatTheRobotStands) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(0.0, 0, 0));
    EXPECT_FALSE(motions.add(ticksAt(0.1, 10, 10))->standing);
    EXPECT_FALSE(motions.add(ticksAt(0.2, 10, 10))->standing);
    for (int i = 3; i < 8; ++i) motions.add(ticksAt(0.1 * i, 10, 10));
    EXPECT_TRUE(motions.add(ticksAt(0.9, 10, 10))->standing);
    EXPECT_FALSE(motions.add(ticksAt(1.0, 20, 20))->standing);
}

TEST(MotionBuilder, ARobotTurnedByHandDoesNotStand) {
    MotionBuilder motions(millimetreVehicle());
    for (int i = 0; i < 100; ++i) {
        const auto motion = motions.add(turningAt(0.02 * i, 0, radFromDeg(40.0)));
        EXPECT_FALSE(i > 50 && motion->standing);
    }
}

TEST(MotionBuilder, ReadsNoTimeThatIsNoNumber) {
    MotionBuilder motions(millimetreVehicle());
    motions.add(ticksAt(0.0, 0, 0));
    EXPECT_FALSE(motions.add(ticksAt(std::numeric_limits<double>::quiet_NaN(), 5, 5)));
    EXPECT_FALSE(motions.add(ticksAt(0.0, 5, 5)));  // the same time again
    EXPECT_NEAR(motions.add(ticksAt(0.1, 10, 10))->distance_m, 0.01, 1e-12);
}

}  // namespace
}  // namespace hedr
