// Whole drives: which of a vehicle's messages become its sensors, and when.
#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/motion.h"
#include "radio/wire/mavlink/mavlink_reports.h"
#include "tests/radio/wire/mavlink/circle_drive.h"

namespace hedr {
namespace {

using test::attitudeAt;
using test::drive;
using test::driven;
using test::Heard;
using test::highresAt;
using test::kRate_rad_s;
using test::kSpeed_m_s;
using test::kTrack_m;
using test::odometryAt;
using test::positionAt;
using test::rateOf;
using test::rawAt;
using test::scaledAt;
using test::sorted;
using test::SpokenMavlink;
using test::wheelsAt;

TEST(MavlinkDrive, UsesTheBestGyroThatIsSent) {
    const auto all = [](SpokenMavlink& robot, double t) {
        robot.say(attitudeAt(t));
        robot.say(rawAt(t));
        robot.say(scaledAt(t));
        robot.say(highresAt(t));
    };
    const auto no_highres = [](SpokenMavlink& robot, double t) {
        robot.say(attitudeAt(t));
        robot.say(rawAt(t));
        robot.say(scaledAt(t));
    };
    const auto raw = [](SpokenMavlink& robot, double t) {
        robot.say(attitudeAt(t));
        robot.say(rawAt(t));
    };
    const auto only_raw = [](SpokenMavlink& robot, double t) { robot.say(rawAt(t)); };
    EXPECT_DOUBLE_EQ(rateOf(driven(3, all).sensors.at(0)), 0.25);
    EXPECT_DOUBLE_EQ(rateOf(driven(3, no_highres).sensors.at(0)), 0.201);
    EXPECT_DOUBLE_EQ(rateOf(driven(3, raw, 3).sensors.at(0)), 0.202);
    EXPECT_NEAR(rateOf(driven(3, raw, 12).sensors.at(0)), 0.2, 1e-7);  // its units are not known
    EXPECT_DOUBLE_EQ(rateOf(driven(3, only_raw, 12).sensors.at(0)), 0.202);
    // One report per message of the chosen kind, after two seconds of listening.
    EXPECT_EQ(driven(3, all).sensors.size(), 100U);
    EXPECT_DOUBLE_EQ(driven(3, all).sensors[0].robot_time_s, 3.0);
}

TEST(MavlinkDrive, PassesOverAGyroThatSpeaksTooSeldom) {
    const auto every = [](int steps) {
        return [steps](SpokenMavlink& robot, double t) {
            robot.say(attitudeAt(t));
            if (std::lround(100 * t) % steps == 0) robot.say(scaledAt(t));
        };
    };
    EXPECT_DOUBLE_EQ(rateOf(driven(3, every(2)).sensors.at(0)), 0.201);
    EXPECT_NEAR(rateOf(driven(3, every(5)).sensors.at(0)), 0.2, 1e-7);
    EXPECT_EQ(driven(3, every(5)).sensors.size(), 100U);
}

TEST(MavlinkDrive, KeepsWhatItChose) {
    SpokenMavlink robot;
    drive(robot, 3, [](auto& r, double t) { r.say(scaledAt(t)); });
    (void)robot.take();
    drive(
        robot, 3,
        [](auto& r, double t) {
            r.say(highresAt(t));
            r.say(attitudeAt(t));
            r.say(positionAt(t));
            r.say(wheelsAt(t));
            r.say(scaledAt(t));
        },
        0, 4.0);
    const Heard heard = sorted(robot.take());
    EXPECT_EQ(heard.sensors.size(), 300U);
    EXPECT_TRUE(heard.poses.empty());
    for (const SensorReport& report : heard.sensors) {
        EXPECT_DOUBLE_EQ(rateOf(report), 0.201);
        EXPECT_EQ(report.odometry, Odometry{});
    }
}

TEST(MavlinkDrive, TakesThePoseFromPositionAndAttitude) {
    const Heard heard = driven(3, [](auto& robot, double t) {
        robot.say(attitudeAt(t));
        if (std::lround(100 * t) % 5 == 0) robot.say(positionAt(t));
    });
    ASSERT_EQ(heard.poses.size(), 20U);
    for (const PoseReport& pose : heard.poses) {
        const double t = pose.robot_time_s;
        EXPECT_NEAR(pose.pose.position.x, 5 * std::sin(0.2 * t), 1e-5);
        EXPECT_NEAR(pose.pose.position.y, 5 * (1 - std::cos(0.2 * t)), 1e-5);  // to the left
        EXPECT_NEAR(pose.pose.heading_rad, 0.2 * t, 1e-6);
        EXPECT_NEAR(pose.yaw_rate_rad_s, 0.2, 1e-7);
    }
    // The odometry comes with the next tick, and only once.
    int with_odometry = 0;
    for (const SensorReport& report : heard.sensors) {
        with_odometry += std::holds_alternative<OdometryPose>(report.odometry) ? 1 : 0;
    }
    EXPECT_EQ(with_odometry, 20);
    EXPECT_EQ(heard.sensors.size(), 100U);
}

TEST(MavlinkDrive, GivesNoPoseWithAnOldAttitude) {
    const Heard heard = driven(5, [](auto& robot, double t) {
        if (t < 3.5) robot.say(attitudeAt(t));
        robot.say(positionAt(t));
    });
    ASSERT_FALSE(heard.poses.empty());
    EXPECT_NEAR(heard.poses.back().robot_time_s, 4.49, 0.015);  // a second after the last
}

TEST(MavlinkDrive, PrefersOdometryToThePosition) {
    const Heard heard = driven(3, [](auto& robot, double t) {
        robot.say(attitudeAt(t));
        robot.say(positionAt(t));
        robot.say(odometryAt(t));
    });
    EXPECT_EQ(heard.poses.size(), 100U);
    EXPECT_NEAR(heard.poses[50].pose.position.y, 5 * (1 - std::cos(0.2 * 3.5)), 1e-5);
    EXPECT_NEAR(heard.poses[50].pose.heading_rad, 0.2 * 3.5, 1e-6);
}

TEST(MavlinkDrive, PrefersWheelsAsOdometry) {
    const Heard heard = driven(3, [](auto& robot, double t) {
        robot.say(wheelsAt(t));
        robot.say(odometryAt(t));
        robot.say(scaledAt(t));
    });
    EXPECT_EQ(heard.poses.size(), 100U);
    ASSERT_EQ(heard.sensors.size(), 100U);
    EXPECT_EQ(heard.sensors[0].odometry, Odometry(WheelTravel{0.95 * 3.0, 1.05 * 3.0}));
}

TEST(MavlinkDrive, TicksByThePoseOrTheWheelsWhereThereIsNoGyro) {
    const Heard pose = driven(3, [](auto& robot, double t) { robot.say(odometryAt(t)); });
    ASSERT_EQ(pose.sensors.size(), 100U);
    EXPECT_TRUE(std::holds_alternative<OdometryPose>(pose.sensors[0].odometry));
    EXPECT_EQ(pose.sensors[0].gyro, Gyro{});
    EXPECT_EQ(pose.hellos.back().heading_source, HeadingSource::kEncoders);
    const Heard wheels = driven(3, [](auto& robot, double t) { robot.say(wheelsAt(t)); });
    ASSERT_EQ(wheels.sensors.size(), 100U);
    EXPECT_TRUE(std::holds_alternative<WheelTravel>(wheels.sensors[0].odometry));
}

TEST(MavlinkDrive, SaysWhatItHasBeforeTheFirstSensors) {
    SpokenMavlink robot;
    drive(robot, 2.5, [](auto& r, double t) {
        MavlinkScaledImu m = scaledAt(t);
        m.temperature = 2000;
        m.xmag = 200;
        r.say(m);
    });
    std::uint16_t capabilities = 0;
    for (const Report& report : robot.take()) {
        if (const auto* hello = std::get_if<HelloReport>(&report))
            capabilities = hello->capabilities;
        if (!std::holds_alternative<SensorReport>(report)) continue;
        EXPECT_EQ(capabilities, kCapabilityGyro | kCapabilityMagnetometer | kCapabilityTemperature |
                                    kCapabilityNoGeometry | kCapabilityRequests);
        return;
    }
    FAIL() << "no sensors";
}

TEST(MavlinkDrive, KeepsFullTurnsOfTheHeading) {
    const Heard heard = driven(70, [](auto& robot, double t) { robot.say(odometryAt(t)); });
    EXPECT_NEAR(heard.poses.back().pose.heading_rad, 0.2 * 70.99, 1e-5);
}

// A companion computer counts from a boot of its own.
TEST(MavlinkDrive, BringsTheClocksOfComponentsTogether) {
    const Heard heard = driven(3, [](auto& robot, double t) {
        robot.say(scaledAt(t));
        MavlinkOdometry m = odometryAt(t);
        m.time_usec += 1'767'268'800'000'000;
        robot.sayAs({7, 197}, m);
    });
    ASSERT_EQ(heard.poses.size(), 100U);
    EXPECT_NEAR(heard.poses[0].robot_time_s, 3.0, 1e-6);
    EXPECT_EQ(heard.hellos.front().boot_id, heard.hellos.back().boot_id);
}

TEST(MavlinkDrive, ListensToTheAutopilotWhereTwoSendTheSame) {
    const Heard heard = driven(3, [](auto& robot, double t) {
        MavlinkScaledImu other = scaledAt(t);
        other.zgyro = 999;
        robot.sayAs({7, 154}, other);
        robot.say(scaledAt(t));
    });
    ASSERT_EQ(heard.sensors.size(), 100U);
    for (const SensorReport& report : heard.sensors) EXPECT_DOUBLE_EQ(rateOf(report), 0.201);
}

TEST(MavlinkDrive, TellsARestartByTheTimeSinceBoot) {
    SpokenMavlink robot;
    const auto say = [](SpokenMavlink& r, double t) {
        r.say(scaledAt(t));
        r.say(odometryAt(t));
    };
    drive(robot, 3, say, 0, 100.0);
    const Heard before = sorted(robot.take());
    say(robot, 0.5);  // before the next heartbeat
    const std::vector<Report> reports = robot.take();
    ASSERT_FALSE(reports.empty());
    const auto* hello = std::get_if<HelloReport>(&reports[0]);
    ASSERT_NE(hello, nullptr);
    EXPECT_NE(hello->boot_id, before.hellos.back().boot_id);
    // It does not listen anew: it is the same robot.
    const Heard after = sorted(reports);
    ASSERT_EQ(after.sensors.size(), 1U);
    EXPECT_DOUBLE_EQ(after.sensors[0].robot_time_s, 0.5);
    EXPECT_EQ(after.poses.size(), 1U);
}

TEST(MavlinkDrive, DropsSamplesThatAreNoNumbers) {
    const Heard heard = driven(3, [](auto& robot, double t) {
        const bool bad = std::lround(100 * t) % 2 == 1;
        MavlinkHighresImu imu = highresAt(t);
        MavlinkOdometry odometry = odometryAt(t);
        if (bad) imu.zgyro = NAN;
        if (bad) odometry.x = INFINITY;
        robot.say(imu);
        robot.say(odometry);
    });
    EXPECT_EQ(heard.sensors.size(), 50U);
    EXPECT_EQ(heard.poses.size(), 50U);
}

// To the end: a tracker's motions of what a rover with wheels and an IMU says.
TEST(MavlinkDrive, BecomesTheMotionThatWasDriven) {
    const Heard heard = driven(12, [](auto& robot, double t) {
        if (std::lround(100 * t) % 5 == 0) robot.say(wheelsAt(t));
        MavlinkHighresImu imu = highresAt(t);
        imu.zgyro = static_cast<float>(-kRate_rad_s);
        robot.say(imu);
    });
    Vehicle vehicle;
    vehicle.geometry.wheelbase_m = kTrack_m;
    vehicle.gyro_bias_rad_s = 0.0;
    MotionBuilder builder(vehicle);
    double distance_m = 0.0;
    double wheels_turn_rad = 0.0;
    double gyro_turn_rad = 0.0;
    double time_s = 0.0;
    for (const SensorReport& report : heard.sensors) {
        const auto motion = builder.add(report);
        if (!motion) continue;
        distance_m += motion->distance_m;
        wheels_turn_rad += motion->odometry_turn_rad.value_or(0.0);
        gyro_turn_rad += motion->gyro_turn_rad.value_or(0.0);
        time_s += motion->dt_s;
    }
    EXPECT_NEAR(time_s, 9.99, 1e-9);
    EXPECT_NEAR(gyro_turn_rad, kRate_rad_s * 9.99, 1e-6);
    EXPECT_NEAR(distance_m, kSpeed_m_s * 9.95, 1e-6);  // the wheels came last 0.04 s before
    EXPECT_NEAR(wheels_turn_rad, kRate_rad_s * 9.95, 1e-6);
    EXPECT_EQ(builder.brokenSamples(), 0U);
}

}  // namespace
}  // namespace hedr
