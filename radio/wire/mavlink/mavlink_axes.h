#pragma once

#include <optional>

#include "core/robot/report.h"
#include "radio/wire/mavlink/mavlink_messages.h"

namespace hedr {

// From MAVLink's axes and units to ours. MAVLink's world is x north, y east, z down, its body x
// forward, y right, z down; yaw is clockwise seen from above. Ours is x north (or forward at the
// start), y west (left), z up; heading is counter-clockwise. Both are right-handed: the turn
// between them is half a turn about x. So x stays, y and z change sign, and so do yaw and the rates
// about z.
//
// A value that is no finite number is none.

struct MavlinkImu {
    std::optional<double> yaw_rate_rad_s{};
    std::optional<double> temperature_c{};
    std::optional<MagneticField> magnetic_field{};  // gauss
};

// RAW_IMU is read as ArduPilot fills it, mrad/s and mgauss; elsewhere its units are not defined.
MavlinkImu imuOf(const MavlinkHighresImu& m);
MavlinkImu imuOf(const MavlinkScaledImu& m);
MavlinkImu imuOf(const MavlinkRawImu& m);

struct MavlinkYaw {
    double heading_rad = 0.0;
    double yaw_rate_rad_s = 0.0;
};
std::optional<MavlinkYaw> yawOf(const MavlinkAttitude& m);

std::optional<Point<World>> positionOf(const MavlinkLocalPositionNed& m);

// In a local frame, north-east-down, forward-right-down, east-north-up or forward-left-up; none in
// another one, or where the estimator says that it failed.
struct MavlinkPose {
    Pose<World> pose{};
    double yaw_rate_rad_s = 0.0;  // 0 where it is not sent
};
std::optional<MavlinkPose> poseOf(const MavlinkOdometry& m);

// Two wheels and more: [0] is the left one, [1] the right one; one: the travel of the robot.
Odometry travelOf(const MavlinkWheelDistance& m);

// Bits of our StatusReport: a sensor that is switched on and not healthy.
std::uint16_t faultsOf(const MavlinkSysStatus& m);

// As SiK radios count: rssi / 1.9 - 127.
std::optional<int> radioOf(const MavlinkRadioStatus& m);

}  // namespace hedr
