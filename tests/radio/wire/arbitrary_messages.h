#pragma once

#include <rapidcheck.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "radio/wire/byte_order.h"
#include "radio/wire/codec.h"
#include "radio/wire/messages.h"

namespace hedr::test {

// Messages whose values lie on the grid of the wire, so that they survive it exactly.

template <class Wire>
Wire anyInteger() {
    using Limits = std::numeric_limits<Wire>;
    return *rc::gen::oneOf(rc::gen::arbitrary<Wire>(),
                           rc::gen::element<Wire>(0, 1, Limits::max(), Limits::min()),
                           rc::gen::map(rc::gen::arbitrary<std::array<std::uint8_t, 8>>(),
                                        [](const std::array<std::uint8_t, 8>& bytes) {
                                            return loadLittle<Wire>(bytes.data());
                                        }));
}

template <class Wire>
double onGrid(double unit) {
    return static_cast<double>(anyInteger<Wire>()) * unit;
}

inline std::string anyText(std::size_t longest) {
    const std::string text =
        *rc::gen::container<std::string>(rc::gen::inRange<char>('\x01', '\x7f'));
    return text.substr(0, longest);
}

inline Pose<World> anyPose() {
    return {{onGrid<std::int32_t>(kMilli), onGrid<std::int32_t>(kMilli)},
            onGrid<std::int32_t>(kTurnUnit_rad)};
}

inline HelloReport anyHello() {
    HelloReport m;
    m.boot_id = anyInteger<std::uint32_t>();
    m.capabilities = anyInteger<std::uint16_t>();
    m.geometry = {onGrid<std::uint32_t>(kMicro), onGrid<std::uint32_t>(kMicro),
                  onGrid<std::uint32_t>(kMicro), onGrid<std::uint32_t>(kMilli)};
    m.heading_source = *rc::gen::element(HeadingSource::kGyro, HeadingSource::kEncoders);
    m.vehicle = anyText(kMaxNameBytes);
    m.firmware = anyText(kMaxNameBytes);
    return m;
}

inline PoseReport anyPoseReport() {
    PoseReport m;
    m.robot_time_s = onGrid<std::uint32_t>(kMicro);
    m.pose = anyPose();
    m.yaw_rate_rad_s = onGrid<std::int16_t>(kMilli);
    m.drift_rad_s = onGrid<std::int16_t>(kDriftUnit_rad_s);
    m.hedr = static_cast<HedrState>(*rc::gen::inRange(0, 3));
    m.reason = static_cast<SuspendReason>(*rc::gen::inRange(0, 4));
    m.standing = *rc::gen::arbitrary<bool>();
    m.calibrated = *rc::gen::arbitrary<bool>();
    return m;
}

inline SensorReport anySensors() {
    SensorReport m;
    m.robot_time_s = onGrid<std::uint32_t>(kMicro);
    m.odometry = WheelTicks{anyInteger<std::int32_t>(), anyInteger<std::int32_t>()};
    if (const auto urad = anyInteger<std::uint32_t>(); urad != 0x80000000U) {
        m.gyro = GyroAngle{urad};
    }
    if (const auto raw = anyInteger<std::int16_t>(); raw != INT16_MIN) {
        m.temperature_c = raw * kTemperatureUnit_c;
    }
    if (*rc::gen::arbitrary<bool>()) {
        m.magnetic_field = {onGrid<std::int16_t>(1), onGrid<std::int16_t>(1),
                            onGrid<std::int16_t>(1)};
    }
    return m;
}

inline StatusReport anyStatus() {
    StatusReport m;
    m.battery_v = onGrid<std::uint16_t>(kMilli);
    m.faults = anyInteger<std::uint16_t>();
    if (const auto raw = anyInteger<std::int8_t>(); raw != INT8_MIN) {
        m.radio_dbm = raw;
    }
    return m;
}

inline Report anyReport() {
    switch (*rc::gen::inRange(0, 8)) {
        case 0:
            return anyHello();
        case 1:
            return anyPoseReport();
        case 2:
            return anySensors();
        case 3:
            return anyStatus();
        case 4:
            return ParameterReport{anyInteger<std::uint8_t>(), anyInteger<std::int32_t>()};
        case 5:
            return AcknowledgeReport{anyInteger<std::uint8_t>(), anyInteger<std::uint8_t>()};
        case 6:
            return EventReport{onGrid<std::uint32_t>(kMicro), anyText(kMaxEventBytes)};
        default:
            return TimeEchoReport{anyInteger<std::uint32_t>(), onGrid<std::uint32_t>(kMicro)};
    }
}

inline Request anyRequest() {
    switch (*rc::gen::inRange(0, 4)) {
        case 0:
            return ParameterGet{anyInteger<std::uint8_t>()};
        case 1:
            return ParameterSet{anyInteger<std::uint8_t>(), anyInteger<std::int32_t>()};
        case 2:
            return RobotCommand{static_cast<CommandKind>(*rc::gen::inRange(0, 5)), anyPose()};
        default:
            return TimeRequest{anyInteger<std::uint32_t>()};
    }
}

// A frame that came out of a decoder, with a payload of its own.
struct KeptFrame {
    std::uint8_t id = 0;
    std::uint16_t sequence = 0;
    std::vector<std::uint8_t> payload;

    Frame frame() const { return {id, sequence, payload}; }
    friend bool operator==(const KeptFrame&, const KeptFrame&) = default;
};

inline KeptFrame keep(const Frame& frame) {
    return {frame.id, frame.sequence, {frame.payload.begin(), frame.payload.end()}};
}

}  // namespace hedr::test
