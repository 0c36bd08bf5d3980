#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "radio/wire/codec.h"
#include "radio/wire/messages.h"
#include "radio/wire/signing/key_text.h"

namespace hedr {

NLOHMANN_JSON_SERIALIZE_ENUM(HeadingSource, {{HeadingSource::kGyro, "gyro"},
                                             {HeadingSource::kEncoders, "encoders"}})
NLOHMANN_JSON_SERIALIZE_ENUM(HedrState, {{HedrState::kOff, "off"},
                                         {HedrState::kActive, "active"},
                                         {HedrState::kSuspended, "suspended"}})
NLOHMANN_JSON_SERIALIZE_ENUM(SuspendReason, {{SuspendReason::kNone, "none"},
                                             {SuspendReason::kStanding, "standing"},
                                             {SuspendReason::kTurning, "turning"},
                                             {SuspendReason::kSearching, "searching"},
                                             {SuspendReason::kOffCorridors, "off_corridors"}})
NLOHMANN_JSON_SERIALIZE_ENUM(CommandKind, {{CommandKind::kNone, "none"},
                                           {CommandKind::kMeasureBias, "measure_bias"},
                                           {CommandKind::kResetPose, "reset_pose"},
                                           {CommandKind::kHedrOn, "hedr_on"},
                                           {CommandKind::kHedrOff, "hedr_off"}})

namespace test {

struct GoldenSignature {
    SigningKey key{};
    std::uint32_t counter = 0;
};

// A golden message: what its JSON says in the units of people.
struct GoldenMessage {
    std::uint16_t sequence = 0;
    std::variant<Report, Request> message;
    std::optional<GoldenSignature> signature{};
};

inline double radOfTurns(double turns) { return turns * 2.0 * kPi; }

inline Pose<World> goldenPose(const nlohmann::json& j) {
    return {{j.at("x_m"), j.at("y_m")}, radOfTurns(j.at("heading_turns"))};
}

inline HelloReport goldenHello(const nlohmann::json& j) {
    HelloReport m;
    m.protocol = j.at("protocol");
    m.boot_id = j.at("boot_id");
    m.capabilities = j.at("capabilities");
    m.geometry = {j.at("left_wheel_diameter_m"), j.at("right_wheel_diameter_m"),
                  j.at("wheelbase_m"), j.at("ticks_per_revolution")};
    m.heading_source = j.at("heading_source");
    m.vehicle = j.at("vehicle");
    m.firmware = j.at("firmware");
    return m;
}

inline PoseReport goldenPoseReport(const nlohmann::json& j) {
    PoseReport m;
    m.robot_time_s = j.at("robot_time_s");
    m.pose = goldenPose(j);
    m.yaw_rate_rad_s = j.at("yaw_rate_rad_s");
    m.drift_rad_s = j.at("drift_rad_s");
    m.hedr = j.at("hedr");
    m.reason = j.at("reason");
    m.standing = j.at("standing");
    m.calibrated = j.at("calibrated");
    return m;
}

inline SensorReport goldenSensors(const nlohmann::json& j) {
    SensorReport m;
    m.robot_time_s = j.at("robot_time_s");
    m.odometry = WheelTicks{j.at("left_ticks"), j.at("right_ticks")};
    if (const auto& angle = j.at("gyro_urad"); !angle.is_null()) {
        m.gyro = GyroAngle{angle};
    }
    if (const auto& temperature = j.at("temperature_c"); !temperature.is_null()) {
        m.temperature_c = temperature.get<double>();
    }
    if (const auto& field = j.at("magnetic_field"); !field.is_null()) {
        m.magnetic_field = {field.at(0), field.at(1), field.at(2)};
    }
    return m;
}

inline StatusReport goldenStatus(const nlohmann::json& j) {
    StatusReport m;
    m.battery_v = j.at("battery_v");
    m.faults = j.at("faults");
    if (const auto& radio = j.at("radio_dbm"); !radio.is_null()) {
        m.radio_dbm = radio.get<int>();
    }
    return m;
}

inline std::variant<Report, Request> goldenMessage(const nlohmann::json& j) {
    const std::string name = j.at("message");
    if (name == "hello") return Report(goldenHello(j));
    if (name == "pose") return Report(goldenPoseReport(j));
    if (name == "sensors") return Report(goldenSensors(j));
    if (name == "status") return Report(goldenStatus(j));
    if (name == "parameter") return Report(ParameterReport{j.at("id"), j.at("value")});
    if (name == "acknowledge") return Report(AcknowledgeReport{j.at("command"), j.at("result")});
    if (name == "event") return Report(EventReport{j.at("robot_time_s"), j.at("text")});
    if (name == "time_echo") return Report(TimeEchoReport{j.at("token"), j.at("robot_time_s")});
    if (name == "parameter_get") return Request(ParameterGet{j.at("id")});
    if (name == "parameter_set") return Request(ParameterSet{j.at("id"), j.at("value")});
    if (name == "command") return Request(RobotCommand{j.at("command"), goldenPose(j)});
    if (name == "time_request") return Request(TimeRequest{j.at("token")});
    throw std::runtime_error("unknown message " + name);
}

inline std::optional<GoldenSignature> goldenSignature(const nlohmann::json& j) {
    if (!j.contains("signed")) return std::nullopt;
    const auto& signature = j.at("signed");
    const std::string key = "name = \"golden\"\nkey = \"" + signature.at("key").get<std::string>();
    return GoldenSignature{parseKey(key + "\"", "golden").value().key, signature.at("counter")};
}

inline GoldenMessage goldenFromJson(const nlohmann::json& j) {
    return {j.at("sequence"), goldenMessage(j), goldenSignature(j)};
}

}  // namespace test
}  // namespace hedr
