#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/geometry/angle.h"
#include "radio/wire/messages.h"
#include "radio/wire/request.h"

namespace hedr {

enum class Dimension : std::uint8_t { kLength, kAngle, kAngularAcceleration, kNumber };

// What a number on the wire stands for, in SI units.
struct ParameterMeaning {
    RobotParameter id{};
    Dimension dimension{};
    double unit = 1.0;  // of one on the wire: metres, radians, rad/s^2, one
};

inline constexpr std::array kParameterMeanings{
    ParameterMeaning{RobotParameter::kLeftWheelDiameterUm, Dimension::kLength, kMicro},
    ParameterMeaning{RobotParameter::kRightWheelDiameterUm, Dimension::kLength, kMicro},
    ParameterMeaning{RobotParameter::kWheelbaseUm, Dimension::kLength, kMicro},
    ParameterMeaning{RobotParameter::kTicksPerRevolutionMilli, Dimension::kNumber, kMilli},
    ParameterMeaning{RobotParameter::kHedrGainUradS2, Dimension::kAngularAcceleration, kMicro},
    ParameterMeaning{RobotParameter::kDominantDirections, Dimension::kNumber, 1.0},
    ParameterMeaning{RobotParameter::kDominantOffset, Dimension::kAngle, kTurnUnit_rad}};

inline double parameterInSi(const ParameterMeaning& meaning, std::int32_t raw) {
    return meaning.unit * static_cast<double>(raw);
}

// None where it does not fit on the wire.
inline std::optional<std::int32_t> parameterOnWire(const ParameterMeaning& meaning, double value) {
    const double raw = std::round(value / meaning.unit);
    if (!(std::abs(raw) <= std::numeric_limits<std::int32_t>::max())) return std::nullopt;
    return static_cast<std::int32_t>(raw);
}

}  // namespace hedr
