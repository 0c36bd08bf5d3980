#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/geometry/angle.h"
#include "radio/firmware/hedr_robot.h"
#include "radio/wire/codec.h"
#include "radio/wire/frame_decoder.h"

namespace hedr {
namespace {

constexpr double kTickLength_m = kPi * 0.2 / 1000.0;  // of the default configuration
constexpr double kWheelbase_m = 0.4;

// A robot and the true motion that it senses.
struct Drive {
    hedr_config config = hedr_default_config();
    hedr_robot robot{};
    double dt_s = 0.01;
    double drift_rad_s = 0.0;  // what the gyro shows besides the truth
    double t_s = 0.0;
    double left_m = 0.0;
    double right_m = 0.0;
    Pose<World> truth{};
    double worst_heading_error_rad = 0.0;

    explicit Drive(bool hedr_on, std::uint32_t bias_time_us = 0) {
        config.hedr_on = hedr_on;
        config.bias_time_us = bias_time_us;
        start();
    }
    void start() {
        ASSERT_TRUE(hedr_robot_init(&robot, &config));
        sample(0.0);
    }
    void sample(double rate_rad_s) {
        hedr_robot_update(&robot,
                          static_cast<std::uint32_t>(static_cast<std::uint64_t>(t_s * 1e6 + 0.5)),
                          static_cast<std::int32_t>(std::floor(left_m / kTickLength_m)),
                          static_cast<std::int32_t>(std::floor(right_m / kTickLength_m)),
                          static_cast<std::int32_t>(std::lround((rate_rad_s + drift_rad_s) * 1e6)));
    }
    void go(double speed_m_s, double rate_rad_s, double duration_s) {
        const auto steps = std::lround(duration_s / dt_s);
        for (long i = 0; i < steps; ++i) {
            const double turn = rate_rad_s * dt_s;
            const double middle = truth.heading_rad + turn / 2;
            const double chord =
                speed_m_s * dt_s * (turn == 0.0 ? 1.0 : std::sin(turn / 2) / (turn / 2));
            truth.position.x += chord * std::cos(middle);
            truth.position.y += chord * std::sin(middle);
            truth.heading_rad += turn;
            left_m += (speed_m_s - rate_rad_s * kWheelbase_m / 2) * dt_s;
            right_m += (speed_m_s + rate_rad_s * kWheelbase_m / 2) * dt_s;
            t_s += dt_s;
            sample(rate_rad_s);
            worst_heading_error_rad =
                std::max(worst_heading_error_rad, std::abs(headingError_rad()));
        }
    }
    hedr_pose pose() const { return hedr_robot_pose(&robot); }
    double heading_rad() const { return pose().heading * (2 * kPi / 1048576.0); }
    double headingError_rad() const { return heading_rad() - truth.heading_rad; }
    double positionError_m() const {
        const hedr_pose p = pose();
        return std::hypot(p.x_mm * 1e-3 - truth.position.x, p.y_mm * 1e-3 - truth.position.y);
    }
    double drift_deg_s() const { return degFromRad(pose().drift_10urad_s * 1e-5); }
};

TEST(FirmwareSine, IsExactToEightDigits) {
    double worst = 0.0;
    for (std::uint64_t angle = 0; angle < (std::uint64_t{1} << 32); angle += 65521) {
        const double exact = std::sin(static_cast<double>(angle) * (2 * kPi / 4294967296.0));
        const double got = hedr_sin(static_cast<std::uint32_t>(angle)) / 1073741824.0;
        worst = std::max(worst, std::abs(got - exact));
    }
    EXPECT_LT(worst, 1e-8);
    EXPECT_EQ(hedr_cos(0x40000000U), 0);
    EXPECT_NEAR(hedr_sin(0xC0000000U), -1073741824.0, 8.0);
}

TEST(FirmwareRobot, DrivesAnArcToTheMillimetre) {
    for (const std::uint8_t source : {HEDR_SOURCE_GYRO, HEDR_SOURCE_ENCODERS}) {
        Drive drive(false);
        drive.config.heading_source = source;
        drive.start();
        drive.go(0.5, 0.25, 3 * 2 * kPi / 0.25);  // radius 2 m, three times around
        drive.go(0.5, -0.5, 4.0);
        EXPECT_LT(drive.positionError_m(), 0.003) << "source " << int{source};
        EXPECT_NEAR(drive.headingError_rad(), 0.0, 2 * kTickLength_m / kWheelbase_m);
    }
}

TEST(FirmwareRobot, KeepsAKilometreStraight) {
    Drive drive(false);
    hedr_robot_reset_pose(&drive.robot, 1000, -2000, 1048576 / 12);
    drive.truth = {{1.0, -2.0}, (1048576 / 12) * 2 * kPi / 1048576.0};
    drive.go(2.0, 0.0, 500.0);
    EXPECT_LT(drive.positionError_m(), 0.003);
}

TEST(FirmwareRobot, KeepsFullTurns) {
    Drive drive(false);
    drive.go(0.0, 6.0, 100 * 2 * kPi / 6.0);
    EXPECT_NEAR(drive.heading_rad(), drive.truth.heading_rad, 1e-3);
    EXPECT_GT(drive.heading_rad(), 99 * 2 * kPi);
}

TEST(FirmwareRobot, MeasuresTheBiasWhileStandingAtTheStart) {
    Drive drive(false, 2000000);
    drive.drift_rad_s = 0.02;
    EXPECT_FALSE(drive.pose().calibrated);
    drive.go(0.0, 0.0, 3.0);
    EXPECT_TRUE(drive.pose().calibrated);
    EXPECT_TRUE(drive.pose().standing);
    drive.go(0.5, 0.1, 60.0);
    EXPECT_NEAR(drive.headingError_rad(), 0.0, 1e-4);
    // The sensors message has the gyro as it is.
    const double angle = hedr_robot_sensors(&drive.robot).gyro_urad * 1e-6;
    EXPECT_NEAR(angle, 0.02 * 63.0 + 6.0, 1e-4);
}

TEST(FirmwareRobot, DrivesWithoutABiasWhenItLeavesAtOnce) {
    Drive drive(false, 5000000);
    drive.drift_rad_s = 0.01;
    drive.go(0.0, 0.0, 0.5);
    drive.go(0.5, 0.0, 10.0);
    EXPECT_FALSE(drive.pose().calibrated);
    EXPECT_NEAR(drive.headingError_rad(), 0.1, 0.002);
}

TEST(FirmwareRobot, OutlivesTheWrapOfTimeCountsAndAngle) {
    Drive drive(false);
    drive.t_s = 4294.9;
    drive.left_m = drive.right_m = 2147483600.0 * kTickLength_m;
    drive.start();
    drive.robot.gyro_urad = 0xFFFFFF00U;
    drive.truth = {};
    std::uint32_t time_us = 4294900000U;
    std::uint32_t ticks = 2147483600U;
    for (int i = 0; i < 1000; ++i) {
        time_us += 10000;
        ticks += 8;
        const auto count = static_cast<std::int32_t>(ticks);
        hedr_robot_update(&drive.robot, time_us, count, count, 1000);
    }
    EXPECT_NEAR(drive.pose().x_mm, 1000 * 8 * kTickLength_m * 1e3, 2.0);
    EXPECT_EQ(hedr_robot_sensors(&drive.robot).gyro_urad, 0xFFFFFF00U + 10000U);
}

TEST(FirmwareRobot, DoesNotJumpWithItsCounters) {
    Drive drive(false);
    drive.go(0.5, 0.0, 10.0);
    const hedr_pose before = drive.pose();
    drive.left_m += 1e4;
    drive.go(0.0, 0.0, 0.1);
    EXPECT_EQ(drive.pose().x_mm, before.x_mm);
    EXPECT_EQ(drive.pose().heading, before.heading);
    drive.t_s += 500.0;  // the clock jumps
    drive.go(0.5, 0.0, 2.0);
    EXPECT_NEAR(drive.pose().x_mm, before.x_mm + 1000, 2);
}

constexpr double kDrift_rad_s = 0.05 * kPi / 180.0;

TEST(FirmwareHedr, RemovesTheDriftOfAStraightDrive) {
    Drive drive(true);
    drive.drift_rad_s = kDrift_rad_s;
    drive.go(0.5, 0.0, 600.0);
    EXPECT_LT(degFromRad(drive.worst_heading_error_rad), 0.5);
    drive.worst_heading_error_rad = 0.0;
    drive.go(0.5, 0.0, 600.0);
    EXPECT_LT(degFromRad(drive.worst_heading_error_rad), 0.15);
    EXPECT_NEAR(drive.drift_deg_s(), 0.05, 0.005);
    EXPECT_EQ(drive.pose().state, HEDR_ACTIVE);
}

// ERRATA of the paper: with the sign as printed the loop feeds back positively.
TEST(FirmwareHedr, FailsWithThePrintedSign) {
    Drive drive(true);
    drive.robot.config.hedr_gain_urad_s2 = -175;
    drive.drift_rad_s = kDrift_rad_s;
    drive.go(0.5, 0.0, 600.0);
    EXPECT_GT(degFromRad(drive.worst_heading_error_rad), 15.0);
}

TEST(FirmwareHedr, DoesNotDependOnTheSamplingRate) {
    for (const double dt_s : {0.005, 0.02, 0.05}) {
        Drive drive(true);
        drive.dt_s = dt_s;
        drive.drift_rad_s = kDrift_rad_s;
        drive.go(0.5, 0.0, 600.0);
        EXPECT_LT(degFromRad(drive.worst_heading_error_rad), 0.5) << dt_s;
        EXPECT_NEAR(drive.drift_deg_s(), 0.05, 0.01) << dt_s;
    }
}

TEST(FirmwareHedr, FollowsEightDirectionsAndATurnedBuilding) {
    Drive drive(true);
    drive.config.dominant_directions = 8;
    drive.config.dominant_offset = 1048576 / 36;  // the building is turned by 10 degrees
    drive.start();
    drive.truth.heading_rad = radFromDeg(55.0);
    hedr_robot_reset_pose(&drive.robot, 0, 0,
                          static_cast<std::int32_t>(std::lround(55.0 / 360.0 * 1048576)));
    drive.drift_rad_s = -kDrift_rad_s;
    drive.go(0.5, 0.0, 600.0);
    EXPECT_LT(degFromRad(drive.worst_heading_error_rad), 0.5);
}

TEST(FirmwareHedr, IsSuspendedInTurnsAndWhileStanding) {
    Drive drive(true);
    EXPECT_EQ(drive.pose().reason, HEDR_WHY_NONE);
    drive.go(0.5, 0.0, 20.0);
    EXPECT_EQ(drive.pose().state, HEDR_ACTIVE);
    drive.go(0.5, 0.5, 1.0);
    EXPECT_EQ(drive.pose().state, HEDR_SUSPENDED);
    EXPECT_EQ(drive.pose().reason, HEDR_WHY_TURNING);
    drive.go(0.0, 0.0, 1.0);
    EXPECT_EQ(drive.pose().state, HEDR_SUSPENDED);
    EXPECT_EQ(drive.pose().reason, HEDR_WHY_STANDING);
    EXPECT_TRUE(drive.pose().standing);
    EXPECT_NEAR(drive.pose().rate_mrad_s, 0, 10);
}

TEST(FirmwareHedr, GivesUpWhatItLearntThirtySecondsAgo) {
    Drive drive(true);
    drive.drift_rad_s = kDrift_rad_s;
    drive.go(0.5, 0.0, 200.0);
    drive.go(0.0, 0.0, 29.0);
    EXPECT_GT(drive.drift_deg_s(), 0.03);
    drive.go(0.0, 0.0, 2.0);
    EXPECT_EQ(drive.drift_deg_s(), 0.0);
    EXPECT_EQ(drive.robot.integral_nrad_s, 0);
}

// Twenty minutes of corridors with right-angled turns, a tele-operator's zigzag of 3 degrees and a
// gyro whose bias walks 0.004 deg/s/sqrt(s).
double missionHeadingRms_deg(unsigned seed, bool hedr_on) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Drive drive(hedr_on, 5000000);
    drive.dt_s = 0.02;
    drive.go(0.0, 0.0, 6.0);
    double sum = 0.0;
    int samples = 0;
    while (drive.t_s < 1200.0) {
        const double leg_s = 2 * kPi * std::uniform_int_distribution<int>(1, 6)(random);
        for (double t = 0.0; t < leg_s; t += drive.dt_s) {
            drive.drift_rad_s += radFromDeg(0.004) * std::sqrt(drive.dt_s) * normal(random);
            drive.go(0.5, radFromDeg(3.0) * std::cos(t), drive.dt_s);
            sum += std::pow(degFromRad(drive.headingError_rad()), 2);
            ++samples;
        }
        const double grid =
            radFromDeg(90.0 * std::round(degFromRad(drive.truth.heading_rad) / 90.0));
        const double turn = grid - drive.truth.heading_rad +
                            radFromDeg(90.0 * (static_cast<int>(random() % 2) * 2 - 1));
        drive.go(0.1, turn / 2.0, 2.0);
    }
    return std::sqrt(sum / samples);
}

TEST(FirmwareHedr, HoldsTheHeadingOfACorridorMission) {
    std::vector<double> with;
    std::vector<double> without;
    for (unsigned seed = 1; seed <= 7; ++seed) {
        with.push_back(missionHeadingRms_deg(seed, true));
        without.push_back(missionHeadingRms_deg(seed, false));
    }
    std::ranges::sort(with);
    std::ranges::sort(without);
    EXPECT_LT(with[3], 0.8);
    EXPECT_LT(with.back(), 1.2);
    EXPECT_GT(without[3], 10.0);
}

Report answerTo(Drive& drive, const Request& request) {
    const FrameBytes asked = encodeRequest(request, 1);
    hedr_decoder decoder;
    hedr_decoder_init(&decoder);
    hedr_request heard{};
    Report report = EventReport{.robot_time_s = 0.0, .text = "no answer"};
    for (const std::uint8_t byte : asked.view()) {
        if (hedr_decoder_push(&decoder, byte, &heard)) {
            std::array<std::uint8_t, HEDR_FRAME_MAX> line{};
            const auto size = hedr_robot_answer(&drive.robot, &heard, 5000000U, line.data(), 77);
            FrameDecoder().feed(std::span(line).first(size),
                                [&](const Frame& frame) { report = decodeReport(frame).value(); });
        }
    }
    return report;
}

TEST(FirmwareRobot, AnswersForItsParameters) {
    Drive drive(true);
    EXPECT_EQ(answerTo(drive, ParameterGet{3}), Report(ParameterReport{3, 400000}));
    EXPECT_EQ(answerTo(drive, ParameterSet{3, 500000}), Report(ParameterReport{3, 500000}));
    EXPECT_EQ(answerTo(drive, ParameterSet{3, -1}), Report(AcknowledgeReport{0x82, 3}));
    EXPECT_EQ(answerTo(drive, ParameterSet{6, 5}), Report(AcknowledgeReport{0x82, 3}));
    EXPECT_EQ(answerTo(drive, ParameterGet{99}), Report(AcknowledgeReport{0x81, 2}));
    EXPECT_EQ(answerTo(drive, ParameterGet{3}), Report(ParameterReport{3, 500000}));
    EXPECT_EQ(answerTo(drive, TimeRequest{4711}), Report(TimeEchoReport{4711, 5.0}));
}

TEST(FirmwareRobot, ObeysCommands) {
    Drive drive(true);
    drive.go(0.5, 0.0, 1.0);
    EXPECT_EQ(answerTo(drive, RobotCommand{CommandKind::kHedrOff}),
              Report(AcknowledgeReport{4, 0}));
    drive.go(0.5, 0.0, 1.0);
    EXPECT_EQ(drive.pose().state, HEDR_OFF);
    EXPECT_EQ(answerTo(drive, RobotCommand{CommandKind::kHedrOn}), Report(AcknowledgeReport{3, 0}));
    EXPECT_EQ(answerTo(drive, RobotCommand{CommandKind::kMeasureBias}),
              Report(AcknowledgeReport{1, 4}));
    EXPECT_EQ(answerTo(drive, RobotCommand{CommandKind::kResetPose, {{-7.5, 2.25}, -8 * kPi}}),
              Report(AcknowledgeReport{2, 0}));
    EXPECT_EQ(drive.pose().x_mm, -7500);
    EXPECT_EQ(drive.pose().y_mm, 2250);
    EXPECT_EQ(drive.pose().heading, -4 * 1048576);
    EXPECT_EQ(answerTo(drive, RobotCommand{}), Report(AcknowledgeReport{0, 1}));
}

TEST(FirmwareRobot, RefusesAConfigurationOutOfRange) {
    hedr_robot robot{};
    hedr_config config = hedr_default_config();
    config.wheelbase_um = 0;
    EXPECT_FALSE(hedr_robot_init(&robot, &config));
}

}  // namespace
}  // namespace hedr
