#pragma once

#include <cstdint>
#include <variant>

#include "core/geometry/frames.h"

namespace hedr {

// What the laptop asks of the robot. The numbers are the wire's, see radio/README.md.

enum class RobotParameter : std::uint8_t {
    kLeftWheelDiameterUm = 1,
    kRightWheelDiameterUm = 2,
    kWheelbaseUm = 3,
    kTicksPerRevolutionMilli = 4,
    kHedrGainUradS2 = 5,
    kDominantDirections = 6,  // 4 or 8
    kDominantOffset = 7,      // 2^-20 turn
};

struct ParameterGet {
    std::uint8_t id = 0;
    friend bool operator==(const ParameterGet&, const ParameterGet&) = default;
};

struct ParameterSet {
    std::uint8_t id = 0;
    std::int32_t value = 0;
    friend bool operator==(const ParameterSet&, const ParameterSet&) = default;
};

enum class CommandKind : std::uint8_t {
    kNone = 0,
    kMeasureBias = 1,
    kResetPose = 2,
    kHedrOn = 3,
    kHedrOff = 4,
};

struct RobotCommand {
    CommandKind kind = CommandKind::kNone;
    Pose<World> pose{};  // of kResetPose
    friend bool operator==(const RobotCommand&, const RobotCommand&) = default;
};

// Answered by a TimeEchoReport with the same token.
struct TimeRequest {
    std::uint32_t token = 0;
    friend bool operator==(const TimeRequest&, const TimeRequest&) = default;
};

using Request = std::variant<ParameterGet, ParameterSet, RobotCommand, TimeRequest>;

// `result` of an AcknowledgeReport.
enum class AcknowledgeResult : std::uint8_t {
    kDone = 0,
    kUnknownCommand = 1,
    kUnknownParameter = 2,
    kOutOfRange = 3,
    kNotWhileMoving = 4,
    kNotSupported = 5,
};

}  // namespace hedr
