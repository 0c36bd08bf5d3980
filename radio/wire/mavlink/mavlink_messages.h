#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace hedr {

// The MAVLink messages that are read or sent, with the names and units of MAVLink's own definition
// (common.xml), so that one can be held against the other. Each has its fields described once, in
// the order of the wire: largest first, then the extensions. That one description reads, writes,
// and gives length and crc_extra, which a test compares with the table in mavlink_messages.cpp.

struct MavlinkHeartbeat {
    static constexpr std::uint32_t kId = 0;
    std::uint32_t custom_mode = 0;
    std::uint8_t type = 0;       // MAV_TYPE
    std::uint8_t autopilot = 0;  // MAV_AUTOPILOT
    std::uint8_t base_mode = 0;
    std::uint8_t system_status = 0;
    std::uint8_t mavlink_version = 3;
};

struct MavlinkSysStatus {
    static constexpr std::uint32_t kId = 1;
    std::uint32_t onboard_control_sensors_present = 0;  // MAV_SYS_STATUS_SENSOR, as the next two
    std::uint32_t onboard_control_sensors_enabled = 0;
    std::uint32_t onboard_control_sensors_health = 0;
    std::uint16_t load = 0;             // 0.1 %
    std::uint16_t voltage_battery = 0;  // mV; 65535: not sent
    std::int16_t current_battery = 0;   // cA
    std::uint16_t drop_rate_comm = 0;   // 0.01 %
    std::uint16_t errors_comm = 0;
    std::array<std::uint16_t, 4> errors_count{};  // four fields of their own on the wire
    std::int8_t battery_remaining = 0;            // %
    std::uint32_t onboard_control_sensors_present_extended = 0;
    std::uint32_t onboard_control_sensors_enabled_extended = 0;
    std::uint32_t onboard_control_sensors_health_extended = 0;
};

using MavlinkParamName = std::array<char, 16>;  // ends with a zero where it is shorter

struct MavlinkParamRequestRead {
    static constexpr std::uint32_t kId = 20;
    std::int16_t param_index = -1;  // -1: by name
    std::uint8_t target_system = 0;
    std::uint8_t target_component = 0;
    MavlinkParamName param_id{};
};

struct MavlinkParamValue {
    static constexpr std::uint32_t kId = 22;
    float param_value = 0.0F;  // of an integer type: its bits
    std::uint16_t param_count = 0;
    std::uint16_t param_index = 0;
    MavlinkParamName param_id{};
    std::uint8_t param_type = 0;  // MAV_PARAM_TYPE
};

struct MavlinkParamSet {
    static constexpr std::uint32_t kId = 23;
    float param_value = 0.0F;
    std::uint8_t target_system = 0;
    std::uint8_t target_component = 0;
    MavlinkParamName param_id{};
    std::uint8_t param_type = 0;
};

struct MavlinkScaledImu {
    static constexpr std::uint32_t kId = 26;
    std::uint32_t time_boot_ms = 0;
    std::int16_t xacc = 0, yacc = 0, zacc = 0;     // mG
    std::int16_t xgyro = 0, ygyro = 0, zgyro = 0;  // mrad/s
    std::int16_t xmag = 0, ymag = 0, zmag = 0;     // mgauss
    std::int16_t temperature = 0;                  // 0.01 °C; 0: none
};

struct MavlinkRawImu {
    static constexpr std::uint32_t kId = 27;
    std::uint64_t time_usec = 0;
    std::int16_t xacc = 0, yacc = 0, zacc = 0;     // raw, as the next six
    std::int16_t xgyro = 0, ygyro = 0, zgyro = 0;  // ArduPilot: mrad/s
    std::int16_t xmag = 0, ymag = 0, zmag = 0;     // ArduPilot: mgauss
    std::uint8_t id = 0;
    std::int16_t temperature = 0;  // 0.01 °C; 0: none
};

struct MavlinkAttitude {
    static constexpr std::uint32_t kId = 30;
    std::uint32_t time_boot_ms = 0;
    float roll = 0.0F, pitch = 0.0F, yaw = 0.0F;                 // rad
    float rollspeed = 0.0F, pitchspeed = 0.0F, yawspeed = 0.0F;  // rad/s
};

struct MavlinkLocalPositionNed {
    static constexpr std::uint32_t kId = 32;
    std::uint32_t time_boot_ms = 0;
    float x = 0.0F, y = 0.0F, z = 0.0F;     // m: north, east, down
    float vx = 0.0F, vy = 0.0F, vz = 0.0F;  // m/s
};

struct MavlinkCommandLong {
    static constexpr std::uint32_t kId = 76;
    std::array<float, 7> param{};  // seven fields of their own on the wire
    std::uint16_t command = 0;     // MAV_CMD
    std::uint8_t target_system = 0;
    std::uint8_t target_component = 0;
    std::uint8_t confirmation = 0;
};

struct MavlinkCommandAck {
    static constexpr std::uint32_t kId = 77;
    std::uint16_t command = 0;
    std::uint8_t result = 0;  // MAV_RESULT
    std::uint8_t progress = 0;
    std::int32_t result_param2 = 0;
    std::uint8_t target_system = 0;
    std::uint8_t target_component = 0;
};

struct MavlinkHighresImu {
    static constexpr std::uint32_t kId = 105;
    std::uint64_t time_usec = 0;
    float xacc = 0.0F, yacc = 0.0F, zacc = 0.0F;      // m/s²
    float xgyro = 0.0F, ygyro = 0.0F, zgyro = 0.0F;   // rad/s
    float xmag = 0.0F, ymag = 0.0F, zmag = 0.0F;      // gauss
    float abs_pressure = 0.0F, diff_pressure = 0.0F;  // hPa
    float pressure_alt = 0.0F;                        // m
    float temperature = 0.0F;                         // °C
    std::uint16_t fields_updated = 0;                 // one bit per field, from xacc on
    std::uint8_t id = 0;
};

struct MavlinkRadioStatus {
    static constexpr std::uint32_t kId = 109;
    std::uint16_t rxerrors = 0;
    std::uint16_t fixed = 0;
    std::uint8_t rssi = 255;  // of its sender, in the radio's own unit; 255: unknown
    std::uint8_t remrssi = 255;
    std::uint8_t txbuf = 0;
    std::uint8_t noise = 0;
    std::uint8_t remnoise = 0;
};

struct MavlinkTimesync {
    static constexpr std::uint32_t kId = 111;
    std::int64_t tc1 = 0;  // ns; 0: a request
    std::int64_t ts1 = 0;  // ns, of who asked
    std::uint8_t target_system = 0;
    std::uint8_t target_component = 0;
};

struct MavlinkStatustext {
    static constexpr std::uint32_t kId = 253;
    std::uint8_t severity = 0;  // MAV_SEVERITY, that of syslog
    std::array<char, 50> text{};
    std::uint16_t id = 0;  // 0: a text of one piece
    std::uint8_t chunk_seq = 0;
};

struct MavlinkOdometry {
    static constexpr std::uint32_t kId = 331;
    std::uint64_t time_usec = 0;
    float x = 0.0F, y = 0.0F, z = 0.0F;                          // m, in frame_id
    std::array<float, 4> q{};                                    // w x y z: child to frame
    float vx = 0.0F, vy = 0.0F, vz = 0.0F;                       // m/s, in child_frame_id
    float rollspeed = 0.0F, pitchspeed = 0.0F, yawspeed = 0.0F;  // rad/s, in child_frame_id
    std::array<float, 21> pose_covariance{};
    std::array<float, 21> velocity_covariance{};
    std::uint8_t frame_id = 0;  // MAV_FRAME
    std::uint8_t child_frame_id = 0;
    std::uint8_t reset_counter = 0;
    std::uint8_t estimator_type = 0;
    std::int8_t quality = 0;  // %; 0: unknown, -1: failed
};

struct MavlinkWheelDistance {
    static constexpr std::uint32_t kId = 9000;
    std::uint64_t time_usec = 0;
    std::array<double, 16> distance{};  // m
    std::uint8_t count = 0;
};

struct MavlinkMessageInfo {
    std::uint32_t id = 0;
    std::uint8_t crc_extra = 0;   // continues the checksum: both sides mean the same fields
    std::uint8_t min_length = 0;  // without the extensions; version 2 may cut zeros off the end
    std::uint8_t max_length = 0;  // with those known here
    const char* name = "";
};

inline constexpr std::size_t kMavlinkMessageCount = 17;
extern const std::array<MavlinkMessageInfo, kMavlinkMessageCount> kMavlinkMessages;

// Null where the id is not known.
const MavlinkMessageInfo* findMavlinkMessage(std::uint32_t id);

}  // namespace hedr
