#pragma once

#include <concepts>
#include <type_traits>

#include "core/geometry/angle.h"
#include "core/robot/report.h"
#include "radio/wire/request.h"

namespace hedr {

// Every message of the protocol: its id and its fields in the order of the wire, described once for
// both directions. The byte tables of radio/README.md say the same to people.

inline constexpr double kMicro = 1e-6;
inline constexpr double kMilli = 1e-3;
inline constexpr double kTurnUnit_rad = 2.0 * kPi / 1048576.0;  // 2^-20 turn
inline constexpr double kDriftUnit_rad_s = 1e-5;
inline constexpr double kTemperatureUnit_c = 0.01;
inline constexpr std::size_t kMaxNameBytes = 63;
inline constexpr std::size_t kMaxEventBytes = 120;

template <class Message>
inline constexpr std::uint8_t kMessageId = 0;
template <>
inline constexpr std::uint8_t kMessageId<HelloReport> = 0x01;
template <>
inline constexpr std::uint8_t kMessageId<PoseReport> = 0x02;
template <>
inline constexpr std::uint8_t kMessageId<SensorReport> = 0x03;
template <>
inline constexpr std::uint8_t kMessageId<StatusReport> = 0x04;
template <>
inline constexpr std::uint8_t kMessageId<ParameterReport> = 0x05;
template <>
inline constexpr std::uint8_t kMessageId<AcknowledgeReport> = 0x06;
template <>
inline constexpr std::uint8_t kMessageId<EventReport> = 0x07;
template <>
inline constexpr std::uint8_t kMessageId<TimeEchoReport> = 0x08;
template <>
inline constexpr std::uint8_t kMessageId<ParameterGet> = 0x81;
template <>
inline constexpr std::uint8_t kMessageId<ParameterSet> = 0x82;
template <>
inline constexpr std::uint8_t kMessageId<RobotCommand> = 0x83;
template <>
inline constexpr std::uint8_t kMessageId<TimeRequest> = 0x84;

// M is Message or const Message: io is a PayloadReader or a PayloadWriter.
template <class M, class Message>
concept Fields = std::same_as<std::remove_const_t<M>, Message>;

template <class Io, class M>
void poseFields(Io& io, M& pose) {
    io.template scaled<std::int32_t>(pose.position.x, kMilli);
    io.template scaled<std::int32_t>(pose.position.y, kMilli);
    io.template wrapping<std::int32_t>(pose.heading_rad, kTurnUnit_rad);
}

template <class Io, Fields<HelloReport> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint8_t>(m.protocol);
    io.template integer<std::uint32_t>(m.boot_id);
    io.template integer<std::uint16_t>(m.capabilities);
    io.template scaled<std::uint32_t>(m.geometry.left_wheel_diameter_m, kMicro);
    io.template scaled<std::uint32_t>(m.geometry.right_wheel_diameter_m, kMicro);
    io.template scaled<std::uint32_t>(m.geometry.wheelbase_m, kMicro);
    io.template scaled<std::uint32_t>(m.geometry.ticks_per_revolution, kMilli);
    io.choice(m.heading_source, HeadingSource::kEncoders);
    io.text(m.vehicle, kMaxNameBytes);
    io.text(m.firmware, kMaxNameBytes);
}

template <class Io, Fields<PoseReport> M>
void fields(Io& io, M& m) {
    io.template wrapping<std::uint32_t>(m.robot_time_s, kMicro);
    poseFields(io, m.pose);
    io.template scaled<std::int16_t>(m.yaw_rate_rad_s, kMilli);
    io.template scaled<std::int16_t>(m.drift_rad_s, kDriftUnit_rad_s);
    io.bits16([&m](auto& bits) {
        bits.choice(m.hedr, HedrState::kSuspended, 2);
        bits.choice(m.reason, SuspendReason::kOffCorridors, 3);
        bits.flag(m.standing);
        bits.flag(m.calibrated);
    });
}

template <class Io, Fields<SensorReport> M>
void fields(Io& io, M& m) {
    io.template wrapping<std::uint32_t>(m.robot_time_s, kMicro);
    io.template oneOf<WheelTicks>(m.odometry, [&io](auto& ticks) {
        io.template integer<std::int32_t>(ticks.left);
        io.template integer<std::int32_t>(ticks.right);
    });
    io.angleOrNone(m.gyro);
    io.template scaledOrNone<std::int16_t>(m.temperature_c, kTemperatureUnit_c);
    io.trailing(m.magnetic_field, 3 * sizeof(std::int16_t), [&io](auto& field) {
        io.template scaled<std::int16_t>(field.x, 1.0);
        io.template scaled<std::int16_t>(field.y, 1.0);
        io.template scaled<std::int16_t>(field.z, 1.0);
    });
}

template <class Io, Fields<StatusReport> M>
void fields(Io& io, M& m) {
    io.template scaled<std::uint16_t>(m.battery_v, kMilli);
    io.template integer<std::uint16_t>(m.faults);
    io.template scaledOrNone<std::int8_t>(m.radio_dbm, 1.0);
}

template <class Io, Fields<ParameterReport> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint8_t>(m.id);
    io.template integer<std::int32_t>(m.value);
}

template <class Io, Fields<AcknowledgeReport> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint8_t>(m.command);
    io.template integer<std::uint8_t>(m.result);
}

template <class Io, Fields<EventReport> M>
void fields(Io& io, M& m) {
    io.template wrapping<std::uint32_t>(m.robot_time_s, kMicro);
    io.text(m.text, kMaxEventBytes);
}

template <class Io, Fields<TimeEchoReport> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint32_t>(m.token);
    io.template wrapping<std::uint32_t>(m.robot_time_s, kMicro);
}

template <class Io, Fields<ParameterGet> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint8_t>(m.id);
}

template <class Io, Fields<ParameterSet> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint8_t>(m.id);
    io.template integer<std::int32_t>(m.value);
}

template <class Io, Fields<RobotCommand> M>
void fields(Io& io, M& m) {
    io.choice(m.kind, CommandKind::kHedrOff);
    poseFields(io, m.pose);
}

template <class Io, Fields<TimeRequest> M>
void fields(Io& io, M& m) {
    io.template integer<std::uint32_t>(m.token);
}

}  // namespace hedr
