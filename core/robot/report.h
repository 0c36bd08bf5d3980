#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/geometry/frames.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What a robot reports, in SI units. Robot time is the robot's own clock, as it came: it may wrap
// (the wire's does, at 2^32 us), jump or start again. core/robot/motion.h makes sense of it.

// Cumulative encoder counts. They wrap at the vehicle's `encoder_counter_bits`.
struct WheelTicks {
    std::int64_t left = 0;
    std::int64_t right = 0;
    friend bool operator==(const WheelTicks&, const WheelTicks&) = default;
};

// Cumulative travel of each wheel.
struct WheelTravel {
    double left_m = 0.0;
    double right_m = 0.0;
    friend bool operator==(const WheelTravel&, const WheelTravel&) = default;
};

// Cumulative signed travel where the wheels are not told apart.
struct PathTravel {
    double distance_m = 0.0;
    friend bool operator==(const PathTravel&, const PathTravel&) = default;
};

// A pose that the robot integrated from its wheels itself, in a frame of its own.
struct OdometryPose {
    double x_m = 0.0;
    double y_m = 0.0;
    double heading_rad = 0.0;
    friend bool operator==(const OdometryPose&, const OdometryPose&) = default;
};

using Odometry = std::variant<std::monostate, WheelTicks, WheelTravel, PathTravel, OdometryPose>;

// Momentary yaw rate, as logged in a sensors.csv.
struct GyroRate {
    double rad_s = 0.0;
    friend bool operator==(const GyroRate&, const GyroRate&) = default;
};

// Cumulative angle in microradians, wrapping at 2^32, as sent on the wire: a lost packet then
// costs no heading.
struct GyroAngle {
    std::uint32_t urad = 0;
    friend bool operator==(const GyroAngle&, const GyroAngle&) = default;
};

using Gyro = std::variant<std::monostate, GyroRate, GyroAngle>;

struct MagneticField {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    friend bool operator==(const MagneticField&, const MagneticField&) = default;
};

struct SensorReport {
    double robot_time_s = 0.0;
    Odometry odometry{};
    Gyro gyro{};
    std::optional<double> temperature_c{};
    std::optional<MagneticField> magnetic_field{};  // in the sensor's own unit
    friend bool operator==(const SensorReport&, const SensorReport&) = default;
};

enum class HedrState : std::uint8_t { kOff, kActive, kSuspended };
enum class SuspendReason : std::uint8_t { kNone, kStanding, kTurning, kSearching, kOffCorridors };

// The pose that the robot computed itself, with its own HEDR.
struct PoseReport {
    double robot_time_s = 0.0;
    Pose<World> pose{};
    double yaw_rate_rad_s = 0.0;
    double drift_rad_s = 0.0;  // what its HEDR removes
    HedrState hedr = HedrState::kOff;
    SuspendReason reason = SuspendReason::kNone;
    bool standing = false;
    bool calibrated = false;  // the gyro bias has been measured
    friend bool operator==(const PoseReport&, const PoseReport&) = default;
};

// Bits of HelloReport::capabilities.
inline constexpr std::uint16_t kCapabilityGyro = 1u << 0;
inline constexpr std::uint16_t kCapabilityMagnetometer = 1u << 1;
inline constexpr std::uint16_t kCapabilityTemperature = 1u << 2;
inline constexpr std::uint16_t kCapabilityHedr = 1u << 3;
inline constexpr std::uint16_t kCapabilityRequests = 1u << 4;
// The geometry is not the robot's, whose language has no words for it. Never on the wire.
inline constexpr std::uint16_t kCapabilityNoGeometry = 1u << 5;
inline constexpr std::uint16_t kCapabilityDemandsSigned = 1u << 15;  // heeds signed requests only

// Who the robot is and how its wheels are made. Sent at start and once a second.
struct HelloReport {
    int protocol = 1;
    std::uint32_t boot_id = 0;  // another number after every restart
    std::uint16_t capabilities = 0;
    VehicleGeometry geometry{};
    HeadingSource heading_source = HeadingSource::kGyro;
    std::string vehicle;
    std::string firmware;
    friend bool operator==(const HelloReport&, const HelloReport&) = default;
};

struct StatusReport {
    double battery_v = 0.0;
    std::uint16_t faults = 0;  // one bit each, radio/README.md
    std::optional<int> radio_dbm{};
    friend bool operator==(const StatusReport&, const StatusReport&) = default;
};

struct EventReport {
    double robot_time_s = 0.0;
    std::string text;
    friend bool operator==(const EventReport&, const EventReport&) = default;
};

struct ParameterReport {
    std::uint8_t id = 0;
    std::int32_t value = 0;
    friend bool operator==(const ParameterReport&, const ParameterReport&) = default;
};

struct AcknowledgeReport {
    std::uint8_t command = 0;
    std::uint8_t result = 0;  // 0 done, otherwise a reason, radio/README.md
    friend bool operator==(const AcknowledgeReport&, const AcknowledgeReport&) = default;
};

// The laptop's token sent back, with the robot's time when it answered.
struct TimeEchoReport {
    std::uint32_t token = 0;
    double robot_time_s = 0.0;
    friend bool operator==(const TimeEchoReport&, const TimeEchoReport&) = default;
};

using Report = std::variant<HelloReport, PoseReport, SensorReport, StatusReport, ParameterReport,
                            AcknowledgeReport, EventReport, TimeEchoReport>;

}  // namespace hedr
