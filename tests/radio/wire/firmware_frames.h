#pragma once

#include <cmath>
#include <vector>

#include "radio/firmware/hedr_robot.h"
#include "radio/wire/codec.h"
#include "radio/wire/signing/siphash.h"

namespace hedr::test {

// The same reports, encoded by the robot's C header, which shares nothing with the codec.
class FirmwareEncoder {
  public:
    explicit FirmwareEncoder(std::uint16_t sequence) : sequence_(sequence) {}

    std::vector<std::uint8_t> encode(const Report& report) {
        const std::uint8_t size =
            std::visit([this](const auto& message) { return put(message); }, report);
        return {frame_.begin(), frame_.begin() + size};
    }

  private:
    template <class Integer>
    static Integer units(double value, double per_unit) {
        return static_cast<Integer>(std::llround(value * per_unit));
    }
    static std::uint32_t micros(double seconds) { return units<std::uint32_t>(seconds, 1e6); }

    std::uint8_t put(const HelloReport& m) {
        const hedr_hello hello{m.boot_id,
                               m.capabilities,
                               micros(m.geometry.left_wheel_diameter_m),
                               micros(m.geometry.right_wheel_diameter_m),
                               micros(m.geometry.wheelbase_m),
                               units<std::uint32_t>(m.geometry.ticks_per_revolution, 1e3),
                               static_cast<std::uint8_t>(m.heading_source),
                               m.vehicle.c_str(),
                               m.firmware.c_str()};
        return hedr_encode_hello(frame_.data(), sequence_, &hello);
    }
    std::uint8_t put(const PoseReport& m) {
        const hedr_pose pose{micros(m.robot_time_s),
                             units<std::int32_t>(m.pose.position.x, 1e3),
                             units<std::int32_t>(m.pose.position.y, 1e3),
                             units<std::int32_t>(m.pose.heading_rad, 1048576.0 / (2.0 * M_PI)),
                             units<std::int16_t>(m.yaw_rate_rad_s, 1e3),
                             units<std::int16_t>(m.drift_rad_s, 1e5),
                             static_cast<std::uint8_t>(m.hedr),
                             static_cast<std::uint8_t>(m.reason),
                             m.standing,
                             m.calibrated};
        return hedr_encode_pose(frame_.data(), sequence_, &pose);
    }
    std::uint8_t put(const SensorReport& m) {
        hedr_sensors sensors{};
        const auto& ticks = std::get<WheelTicks>(m.odometry);
        sensors.time_us = micros(m.robot_time_s);
        sensors.left_ticks = static_cast<std::int32_t>(ticks.left);
        sensors.right_ticks = static_cast<std::int32_t>(ticks.right);
        if (const auto* angle = std::get_if<GyroAngle>(&m.gyro)) {
            sensors.has_gyro = 1;
            sensors.gyro_urad = angle->urad;
        }
        sensors.temperature_centi_c = m.temperature_c
                                          ? units<std::int16_t>(*m.temperature_c, 1e2)
                                          : static_cast<std::int16_t>(HEDR_NO_TEMPERATURE);
        if (m.magnetic_field) {
            sensors.has_magnetometer = 1;
            sensors.magnetometer[0] = units<std::int16_t>(m.magnetic_field->x, 1);
            sensors.magnetometer[1] = units<std::int16_t>(m.magnetic_field->y, 1);
            sensors.magnetometer[2] = units<std::int16_t>(m.magnetic_field->z, 1);
        }
        return hedr_encode_sensors(frame_.data(), sequence_, &sensors);
    }
    std::uint8_t put(const StatusReport& m) {
        const hedr_status status{units<std::uint16_t>(m.battery_v, 1e3), m.faults,
                                 static_cast<std::int8_t>(m.radio_dbm.value_or(HEDR_NO_RADIO))};
        return hedr_encode_status(frame_.data(), sequence_, &status);
    }
    std::uint8_t put(const ParameterReport& m) {
        return hedr_encode_parameter(frame_.data(), sequence_, m.id, m.value);
    }
    std::uint8_t put(const AcknowledgeReport& m) {
        return hedr_encode_acknowledge(frame_.data(), sequence_, m.command, m.result);
    }
    std::uint8_t put(const EventReport& m) {
        return hedr_encode_event(frame_.data(), sequence_, micros(m.robot_time_s), m.text.c_str());
    }
    std::uint8_t put(const TimeEchoReport& m) {
        return hedr_encode_time_echo(frame_.data(), sequence_, m.token, micros(m.robot_time_s));
    }

    std::uint16_t sequence_;
    std::vector<std::uint8_t> frame_ = std::vector<std::uint8_t>(HEDR_FRAME_MAX);
};

// What the robot makes of bytes from the laptop.
inline std::vector<hedr_request> firmwareRequests(std::span<const std::uint8_t> bytes) {
    std::vector<hedr_request> requests;
    hedr_decoder decoder;
    hedr_decoder_init(&decoder);
    hedr_request request{};
    for (const std::uint8_t byte : bytes) {
        if (hedr_decoder_push(&decoder, byte, &request)) {
            requests.push_back(request);
            request = {};
        }
    }
    return requests;
}

// The robot's signing, with an EEPROM that is written by `keep` of the C header, which takes no
// context: one robot at a time.
class FirmwareSigner {
  public:
    FirmwareSigner(const SigningKey& key, std::uint32_t said, std::uint32_t heard = 0) : key_(key) {
        eeprom = {said, heard};
        restart();
    }

    void restart() {
        hedr_signing_init(&signing_, key_.data(), &eeprom, [](const hedr_counters* counters) {
            eeprom = *counters;
            ++writes;
        });
        hedr_decoder_init(&decoder_);
    }
    // Empty where the counters are used up.
    std::vector<std::uint8_t> sign(std::vector<std::uint8_t> frame) {
        const auto size = static_cast<std::uint8_t>(frame.size());
        frame.resize(HEDR_SIGNED_FRAME_MAX);
        frame.resize(hedr_sign(&signing_, frame.data(), size));
        return frame;
    }
    std::vector<hedr_request> hear(std::span<const std::uint8_t> bytes) {
        std::vector<hedr_request> requests;
        hedr_request request{};
        for (const std::uint8_t byte : bytes) {
            if (hedr_decoder_push_signed(&decoder_, &signing_, byte, &request)) {
                requests.push_back(request);
                request = {};
            }
        }
        return requests;
    }

    static inline hedr_counters eeprom{};
    static inline int writes = 0;

  private:
    SigningKey key_;
    hedr_signing signing_{};
    hedr_decoder decoder_{};
};

inline Request asRequest(const hedr_request& q) {
    switch (q.id) {
        case HEDR_ID_PARAMETER_GET:
            return ParameterGet{q.number};
        case HEDR_ID_PARAMETER_SET:
            return ParameterSet{q.number, q.value};
        case HEDR_ID_COMMAND:
            return RobotCommand{
                static_cast<CommandKind>(q.number),
                {{q.x_mm * 1e-3, q.y_mm * 1e-3}, q.heading * (2.0 * M_PI / 1048576.0)}};
        default:
            return TimeRequest{q.token};
    }
}

}  // namespace hedr::test
