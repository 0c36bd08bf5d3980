#include "radio/wire/mavlink/mavlink_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(MavlinkAxes, TurnsAnImuUpsideUp) {
    const MavlinkScaledImu scaled{
        .zgyro = 250, .xmag = 200, .ymag = 30, .zmag = -400, .temperature = 2150};
    const MavlinkImu imu = imuOf(scaled);
    EXPECT_DOUBLE_EQ(imu.yaw_rate_rad_s.value(), -0.25);
    EXPECT_DOUBLE_EQ(imu.temperature_c.value(), 21.5);
    EXPECT_DOUBLE_EQ(imu.magnetic_field->x, 0.2);
    EXPECT_DOUBLE_EQ(imu.magnetic_field->y, -0.03);
    EXPECT_DOUBLE_EQ(imu.magnetic_field->z, 0.4);

    const MavlinkRawImu raw{.zgyro = -1000, .xmag = 1, .temperature = -50};
    EXPECT_DOUBLE_EQ(imuOf(raw).yaw_rate_rad_s.value(), 1.0);
    EXPECT_DOUBLE_EQ(imuOf(raw).temperature_c.value(), -0.5);
    EXPECT_DOUBLE_EQ(imuOf(raw).magnetic_field->x, 0.001);

    const MavlinkHighresImu highres{.zgyro = 0.5F,
                                    .xmag = 0.25F,
                                    .ymag = 0.5F,
                                    .zmag = -0.75F,
                                    .temperature = 36.5F,
                                    .fields_updated = 0xFFFF};
    EXPECT_EQ(imuOf(highres).yaw_rate_rad_s, -0.5);
    EXPECT_EQ(imuOf(highres).temperature_c, 36.5);
    EXPECT_EQ(imuOf(highres).magnetic_field, (MagneticField{0.25, -0.5, 0.75}));
}

TEST(MavlinkAxes, LeavesOutWhatAnImuDoesNotSend) {
    EXPECT_FALSE(imuOf(MavlinkScaledImu{}).temperature_c);
    EXPECT_FALSE(imuOf(MavlinkScaledImu{}).magnetic_field);
    MavlinkHighresImu m{.zgyro = 0.5F, .xmag = 0.25F, .temperature = 36.5F};
    m.fields_updated = 0x0020;
    EXPECT_TRUE(imuOf(m).yaw_rate_rad_s);
    EXPECT_FALSE(imuOf(m).temperature_c);
    EXPECT_FALSE(imuOf(m).magnetic_field);
    m.fields_updated = 0x11C0;
    EXPECT_FALSE(imuOf(m).yaw_rate_rad_s);
    EXPECT_TRUE(imuOf(m).temperature_c);
    EXPECT_TRUE(imuOf(m).magnetic_field);
    m.fields_updated = 0;  // as senders do that do not know the bits
    EXPECT_TRUE(imuOf(m).yaw_rate_rad_s);
}

TEST(MavlinkAxes, DropsWhatIsNoFiniteNumber) {
    for (const float bad : {kNan, kInf, -kInf}) {
        EXPECT_FALSE(imuOf(MavlinkHighresImu{.zgyro = bad}).yaw_rate_rad_s);
        EXPECT_FALSE(imuOf(MavlinkHighresImu{.temperature = bad}).temperature_c);
        EXPECT_FALSE(imuOf(MavlinkHighresImu{.ymag = bad}).magnetic_field);
        EXPECT_FALSE(yawOf(MavlinkAttitude{.yaw = bad}));
        EXPECT_FALSE(yawOf(MavlinkAttitude{.yawspeed = bad}));
        EXPECT_FALSE(positionOf(MavlinkLocalPositionNed{.x = bad}));
        EXPECT_FALSE(positionOf(MavlinkLocalPositionNed{.y = bad}));
        EXPECT_FALSE(poseOf(MavlinkOdometry{.x = bad, .q = {1, 0, 0, 0}, .frame_id = 1}));
        EXPECT_FALSE(poseOf(MavlinkOdometry{.y = bad, .q = {1, 0, 0, 0}, .frame_id = 1}));
        EXPECT_FALSE(poseOf(MavlinkOdometry{.q = {1, bad, 0, 0}, .frame_id = 1}));
        const auto pose =
            poseOf(MavlinkOdometry{.q = {1, 0, 0, 0}, .yawspeed = bad, .frame_id = 1});
        EXPECT_EQ(pose->yaw_rate_rad_s, 0.0);
        const double wide = static_cast<double>(bad);
        EXPECT_EQ(travelOf({.distance = {wide, 1.0}, .count = 2}), Odometry{});
        EXPECT_EQ(travelOf({.distance = {1.0, wide}, .count = 2}), Odometry{});
        EXPECT_EQ(travelOf({.distance = {wide}, .count = 1}), Odometry{});
    }
    EXPECT_FALSE(poseOf(MavlinkOdometry{.frame_id = 1}));  // a quaternion of zeros
}

TEST(MavlinkAxes, TurnsYawAndEastAround) {
    const auto yaw = yawOf(MavlinkAttitude{.yaw = 0.5F, .yawspeed = -0.25F});
    EXPECT_EQ(yaw->heading_rad, -0.5);
    EXPECT_EQ(yaw->yaw_rate_rad_s, 0.25);
    EXPECT_EQ(positionOf(MavlinkLocalPositionNed{.x = 3.0F, .y = 2.0F}), (Point<World>{3.0, -2.0}));
}

std::array<float, 4> turnedAboutZ(double rad) {
    return {static_cast<float>(std::cos(rad / 2)), 0.0F, 0.0F,
            static_cast<float>(std::sin(rad / 2))};
}

void expectPose(const std::optional<MavlinkPose>& got, Pose<World> pose, double rate) {
    ASSERT_TRUE(got);
    EXPECT_NEAR(got->pose.position.x, pose.position.x, 1e-6);
    EXPECT_NEAR(got->pose.position.y, pose.position.y, 1e-6);
    EXPECT_NEAR(got->pose.heading_rad, pose.heading_rad, 1e-6);
    EXPECT_NEAR(got->yaw_rate_rad_s, rate, 1e-6);
}

// The robot is 3 north, 2 east, has turned 0.5 to the left of north and goes on turning left.
TEST(MavlinkAxes, ReadsOdometryInEachOfItsFrames) {
    const Pose<World> pose{{3.0, -2.0}, 0.5};
    for (const int down : {1, 20, 18, 14, 16}) {
        const MavlinkOdometry m{.x = 3,
                                .y = 2,
                                .q = turnedAboutZ(-0.5),
                                .yawspeed = -0.1F,
                                .frame_id = static_cast<std::uint8_t>(down),
                                .child_frame_id = 12};
        expectPose(poseOf(m), pose, 0.1);
    }
    for (const int up : {4, 15, 17, 19}) {
        const MavlinkOdometry m{.x = 2,
                                .y = 3,
                                .q = turnedAboutZ(kPi / 2 + 0.5),
                                .yawspeed = 0.1F,
                                .frame_id = static_cast<std::uint8_t>(up),
                                .child_frame_id = 13};
        expectPose(poseOf(m), pose, 0.1);
    }
    const MavlinkOdometry left{.x = 3,
                               .y = -2,
                               .q = turnedAboutZ(0.5),
                               .yawspeed = 0.1F,
                               .frame_id = 21,
                               .child_frame_id = 21};
    expectPose(poseOf(left), pose, 0.1);
}

TEST(MavlinkAxes, ReadsTheYawOfATiltedRobot) {
    // Yaw 0.7, then pitch 0.3, then roll -0.2, of north-east-down.
    const double y = 0.35;
    const double p = 0.15;
    const double r = -0.1;
    const auto f = [](double value) { return static_cast<float>(value); };
    const std::array<float, 4> q{
        f(std::cos(r) * std::cos(p) * std::cos(y) + std::sin(r) * std::sin(p) * std::sin(y)),
        f(std::sin(r) * std::cos(p) * std::cos(y) - std::cos(r) * std::sin(p) * std::sin(y)),
        f(std::cos(r) * std::sin(p) * std::cos(y) + std::sin(r) * std::cos(p) * std::sin(y)),
        f(std::cos(r) * std::cos(p) * std::sin(y) - std::sin(r) * std::sin(p) * std::cos(y))};
    const auto pose = poseOf({.q = q, .frame_id = 1, .child_frame_id = 12});
    EXPECT_NEAR(pose->pose.heading_rad, -0.7, 1e-6);
}

TEST(MavlinkAxes, RefusesOdometryThatSaysNothingOfAPlace) {
    const auto q = turnedAboutZ(0.0);
    EXPECT_FALSE(poseOf({.q = q, .frame_id = 0}));   // global
    EXPECT_FALSE(poseOf({.q = q, .frame_id = 12}));  // the body's own
    EXPECT_FALSE(poseOf({.q = q, .frame_id = 1, .quality = -1}));
    EXPECT_TRUE(poseOf({.q = q, .frame_id = 1, .quality = 0}));
}

TEST(MavlinkAxes, TellsWheelsFromATravel) {
    EXPECT_EQ(travelOf({.distance = {1.5, -2.5, 9.0}, .count = 3}),
              Odometry(WheelTravel{1.5, -2.5}));
    EXPECT_EQ(travelOf({.distance = {1.5, 7.0}, .count = 1}), Odometry(PathTravel{1.5}));
    EXPECT_EQ(travelOf({.distance = {1.5}, .count = 0}), Odometry{});
}

TEST(MavlinkAxes, TakesForAFaultWhatIsSwitchedOnAndIll) {
    const std::uint32_t gyro = 0x1;
    const std::uint32_t motors = 0x8000;
    const std::uint32_t battery = 0x2000000;
    MavlinkSysStatus m{.onboard_control_sensors_enabled = gyro | motors | battery};
    EXPECT_EQ(faultsOf(m), 1U << 2 | 1U << 3 | 1U << 4);
    m.onboard_control_sensors_health = gyro | battery;
    EXPECT_EQ(faultsOf(m), 1U << 4);
    m.onboard_control_sensors_enabled = gyro;
    EXPECT_EQ(faultsOf(m), 0U);
}

TEST(MavlinkAxes, ReadsTheStrengthOfTheRadio) {
    EXPECT_EQ(radioOf({.rssi = 190}), -27);
    EXPECT_EQ(radioOf({.rssi = 0}), -127);
    EXPECT_EQ(radioOf({.rssi = 255}), std::nullopt);
}

}  // namespace
}  // namespace hedr
