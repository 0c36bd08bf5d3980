#include "radio/wire/mavlink/mavlink_reports.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr std::uint8_t kAutopilotComponent = 1;  // MAV_COMP_ID_AUTOPILOT1
constexpr std::uint8_t kGroundStation = 6;       // MAV_TYPE_GCS
constexpr std::uint8_t kArduPilot = 3;           // MAV_AUTOPILOT_ARDUPILOTMEGA
constexpr std::uint16_t kNoVoltage = 65535;
constexpr double kOldAttitude_s = 1.0;

std::string autopilotName(std::uint8_t mav_autopilot) {
    switch (mav_autopilot) {
        case 0:
            return "generic autopilot";
        case kArduPilot:
            return "ArduPilot";
        case 8:
            return "no autopilot";
        case 12:
            return "PX4";
        default:
            return "autopilot " + std::to_string(mav_autopilot);
    }
}

struct BootStamp {
    std::uint32_t ms;
};
struct MicrosecondStamp {
    std::uint64_t us;
};

template <class Message>
auto stampOf(const Message& m) {
    if constexpr (requires { m.time_boot_ms; }) {
        return BootStamp{m.time_boot_ms};
    } else {
        return MicrosecondStamp{m.time_usec};
    }
}

double timeBy(MavlinkClock& clock, std::uint8_t component, BootStamp stamp) {
    return clock.ofBoot_s(component, stamp.ms);
}
double timeBy(MavlinkClock& clock, std::uint8_t component, MicrosecondStamp stamp) {
    return clock.ofMicroseconds_s(component, stamp.us);
}

// Calls take(message) where the frame is one of the Messages.
template <class... Messages, class Take>
void readOneOf(const MavlinkFrame& frame, Take take) {
    const auto read = [&]<class Message>(std::type_identity<Message>) {
        if (frame.message_id != Message::kId) return false;
        take(readMavlink<Message>(frame.payload));
        return true;
    };
    (void)(read(std::type_identity<Messages>{}) || ...);
}

}  // namespace

MavlinkParameterCoding MavlinkReports::parameterCoding() const {
    return autopilot_ == kArduPilot ? MavlinkParameterCoding::kValue
                                    : MavlinkParameterCoding::kBits;
}

// A gyro that was chosen is kept, so it is the one to come oftener.
std::array<std::uint32_t, 4> MavlinkReports::neededMessages() const {
    const bool ardupilot = autopilot_ == kArduPilot;
    const auto usual = ardupilot ? MavlinkRawImu::kId : MavlinkHighresImu::kId;
    const auto tick = choice_.tick();
    const std::uint32_t imu = tick == MavlinkSensor::kHighresImu  ? MavlinkHighresImu::kId
                              : tick == MavlinkSensor::kScaledImu ? MavlinkScaledImu::kId
                              : tick == MavlinkSensor::kRawImu    ? MavlinkRawImu::kId
                                                                  : usual;
    const bool odometry = choice_.pose() == MavlinkSensor::kOdometry;
    return {imu, MavlinkAttitude::kId, MavlinkWheelDistance::kId,
            odometry ? MavlinkOdometry::kId : MavlinkLocalPositionNed::kId};
}

void MavlinkReports::feed(std::span<const std::uint8_t> bytes, const OnReport& on_report) {
    decoder_.feed(bytes, [&](const MavlinkFrame& frame) { take(frame, on_report); });
}

void MavlinkReports::take(const MavlinkFrame& frame, const OnReport& on_report) {
    const Context context{{frame.system, frame.component}, on_report};
    const auto take_known = [&](const auto& message) { take(message, context); };
    // The radio modems speak for themselves, as a system of their own.
    readOneOf<MavlinkHeartbeat, MavlinkRadioStatus>(frame, take_known);
    if (vehicle_ == context.from) ++robot_frames_;
    if (!vehicle_ || vehicle_->system != frame.system) return;
    readOneOf<MavlinkHighresImu, MavlinkScaledImu, MavlinkRawImu, MavlinkAttitude, MavlinkOdometry,
              MavlinkLocalPositionNed, MavlinkWheelDistance, MavlinkParamValue, MavlinkCommandAck>(
        frame, take_known);
    if (vehicle_ != context.from) return;
    readOneOf<MavlinkSysStatus, MavlinkTimesync, MavlinkStatustext>(frame, take_known);
}

void MavlinkReports::take(const MavlinkHeartbeat& m, const Context& context) {
    if (m.type == kGroundStation) return;
    const bool better = vehicle_ && vehicle_->component != kAutopilotComponent &&
                        context.from.component == kAutopilotComponent;
    if (!vehicle_ || better) follow(context.from);
    if (vehicle_ != context.from) return;
    autopilot_ = m.autopilot;
    choice_.trustRawImu(autopilot_ == kArduPilot);
    texts_.tick([&](std::string text) {
        context.on_report(EventReport{clock_.latest_s(), std::move(text)});
    });
    sayHello(context);
}

void MavlinkReports::follow(MavlinkAddress address) {
    const bool same_system = vehicle_ && vehicle_->system == address.system;
    vehicle_ = address;
    if (same_system) return;
    ++boot_id_;
    clock_ = {};
    choice_ = {};
    texts_ = {};
    status_ = {};
    has_temperature_ = has_magnetometer_ = false;
    attitude_.reset();
    heading_rad_.reset();
    odometry_ = {};
}

// What was chosen stays: it is the same robot.
void MavlinkReports::restart(const Context& context) {
    ++boot_id_;
    clock_ = {};
    attitude_.reset();
    heading_rad_.reset();
    odometry_ = {};
    sayHello(context);
}

void MavlinkReports::sayHello(const Context& context) {
    HelloReport hello;
    hello.boot_id = boot_id_;
    hello.vehicle = "MAVLink system " + std::to_string(vehicle_->system);
    hello.firmware = autopilotName(autopilot_);
    const bool gyro = choice_.gyro();
    if (choice_.made() && !gyro) hello.heading_source = HeadingSource::kEncoders;
    hello.capabilities = static_cast<std::uint16_t>(
        kCapabilityNoGeometry | kCapabilityRequests | (gyro ? kCapabilityGyro : 0U) |
        (has_magnetometer_ ? kCapabilityMagnetometer : 0U) |
        (has_temperature_ ? kCapabilityTemperature : 0U));
    context.on_report(hello);
}

template <class Stamp>
double MavlinkReports::robotTime_s(const Stamp& stamp, const Context& context) {
    const double time_s = timeBy(clock_, context.from.component, stamp);
    if (!clock_.restarted(vehicle_->component)) return time_s;
    restart(context);
    return timeBy(clock_, context.from.component, stamp);
}

template <class Message>
std::optional<double> MavlinkReports::use(MavlinkSensor sensor, const Message& m,
                                          const Context& context) {
    const double time_s = robotTime_s(stampOf(m), context);
    const bool chosen = choice_.made();
    const bool preferred = vehicle_ == context.from;
    const bool used = choice_.hear(sensor, context.from.component, preferred, time_s);
    if (!chosen && choice_.made()) sayHello(context);
    return used ? std::optional(time_s) : std::nullopt;
}

template <class Imu>
void MavlinkReports::takeImu(MavlinkSensor sensor, const Imu& m, const Context& context) {
    const MavlinkImu imu = imuOf(m);
    if (!imu.yaw_rate_rad_s) return;
    const std::optional<double> time_s = use(sensor, m, context);
    if (choice_.tick() != sensor) return;
    has_temperature_ = has_temperature_ || imu.temperature_c;
    has_magnetometer_ = has_magnetometer_ || imu.magnetic_field;
    if (!time_s) return;
    saySensors({.robot_time_s = *time_s,
                .gyro = GyroRate{*imu.yaw_rate_rad_s},
                .temperature_c = imu.temperature_c,
                .magnetic_field = imu.magnetic_field},
               context);
}

void MavlinkReports::take(const MavlinkScaledImu& m, const Context& context) {
    takeImu(MavlinkSensor::kScaledImu, m, context);
}
void MavlinkReports::take(const MavlinkRawImu& m, const Context& context) {
    takeImu(MavlinkSensor::kRawImu, m, context);
}
void MavlinkReports::take(const MavlinkHighresImu& m, const Context& context) {
    takeImu(MavlinkSensor::kHighresImu, m, context);
}

void MavlinkReports::take(const MavlinkAttitude& m, const Context& context) {
    const std::optional<MavlinkYaw> yaw = yawOf(m);
    if (!yaw) return;
    const auto time_s = use(MavlinkSensor::kAttitude, m, context);
    if (!time_s) return;
    attitude_ = Attitude{*time_s, *yaw};
    if (choice_.tick() != MavlinkSensor::kAttitude) return;
    saySensors({.robot_time_s = *time_s, .gyro = GyroRate{yaw->yaw_rate_rad_s}}, context);
}

void MavlinkReports::take(const MavlinkLocalPositionNed& m, const Context& context) {
    const std::optional<Point<World>> position = positionOf(m);
    if (!position) return;
    const auto time_s = use(MavlinkSensor::kLocalPosition, m, context);
    if (!time_s || choice_.pose() != MavlinkSensor::kLocalPosition) return;
    if (!attitude_ || std::abs(*time_s - attitude_->robot_time_s) > kOldAttitude_s) return;
    const MavlinkYaw& yaw = attitude_->yaw;
    sayPose(*time_s, {*position, yaw.heading_rad}, yaw.yaw_rate_rad_s, context);
}

void MavlinkReports::take(const MavlinkOdometry& m, const Context& context) {
    const std::optional<MavlinkPose> pose = poseOf(m);
    if (!pose) return;
    const auto time_s = use(MavlinkSensor::kOdometry, m, context);
    if (!time_s || choice_.pose() != MavlinkSensor::kOdometry) return;
    sayPose(*time_s, pose->pose, pose->yaw_rate_rad_s, context);
    if (choice_.tick() == MavlinkSensor::kOdometry) {
        saySensors({.robot_time_s = *time_s}, context);
    }
}

void MavlinkReports::take(const MavlinkWheelDistance& m, const Context& context) {
    const Odometry travel = travelOf(m);
    if (std::holds_alternative<std::monostate>(travel)) return;
    const auto time_s = use(MavlinkSensor::kWheelDistance, m, context);
    if (!time_s) return;
    odometry_ = travel;
    if (choice_.tick() == MavlinkSensor::kWheelDistance) {
        saySensors({.robot_time_s = *time_s}, context);
    }
}

// Without wheels the pose is the odometry as well.
void MavlinkReports::sayPose(double robot_time_s, Pose<World> pose, double yaw_rate_rad_s,
                             const Context& context) {
    const double last_rad = heading_rad_.value_or(0.0);
    pose.heading_rad = last_rad + wrapAngle(pose.heading_rad - last_rad);
    heading_rad_ = pose.heading_rad;
    if (!choice_.wheels()) {
        odometry_ = OdometryPose{pose.position.x, pose.position.y, pose.heading_rad};
    }
    context.on_report(
        PoseReport{.robot_time_s = robot_time_s, .pose = pose, .yaw_rate_rad_s = yaw_rate_rad_s});
}

void MavlinkReports::saySensors(SensorReport report, const Context& context) {
    report.odometry = std::exchange(odometry_, {});
    context.on_report(report);
}

void MavlinkReports::take(const MavlinkSysStatus& m, const Context& context) {
    constexpr double kMillivolt_v = 1e-3;
    status_.battery_v = m.voltage_battery == kNoVoltage ? 0.0 : kMillivolt_v * m.voltage_battery;
    status_.faults = faultsOf(m);
    context.on_report(status_);
}

void MavlinkReports::take(const MavlinkRadioStatus& m, const Context& context) {
    status_.radio_dbm = radioOf(m);
    if (vehicle_) context.on_report(status_);
}

void MavlinkReports::take(const MavlinkStatustext& m, const Context& context) {
    texts_.add(m, [&](std::string text) {
        context.on_report(EventReport{clock_.latest_s(), std::move(text)});
    });
}

void MavlinkReports::take(const MavlinkParamValue& m, const Context& context) {
    if (const auto parameter = parameterOf(m, parameterCoding())) context.on_report(*parameter);
}

void MavlinkReports::take(const MavlinkCommandAck& m, const Context& context) {
    if (const auto acknowledge = acknowledgeOf(m)) context.on_report(*acknowledge);
}

// An answer to somebody else has another target, or a time where our tokens have 32 bits.
void MavlinkReports::take(const MavlinkTimesync& m, const Context& context) {
    const bool to_us = m.target_system == 0 || m.target_system == kMavlinkOwnSystem;
    const bool token = m.ts1 >= 0 && m.ts1 <= std::numeric_limits<std::uint32_t>::max();
    if (m.tc1 <= 0 || !to_us || !token) return;
    const MicrosecondStamp stamp{static_cast<std::uint64_t>(m.tc1) / 1000U};
    context.on_report(TimeEchoReport{.token = static_cast<std::uint32_t>(m.ts1),
                                     .robot_time_s = robotTime_s(stamp, context)});
}

}  // namespace hedr
