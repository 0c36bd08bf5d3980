#include "radio/link/robot_parameters.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "radio/wire/parameters.h"

namespace hedr {

namespace {

struct KeyOnRobot {
    std::string_view key;  // of the vehicle file, in SI like the meaning
    RobotParameter id;
};

constexpr std::array kKeysOnRobot{
    KeyOnRobot{"left_wheel_diameter_m", RobotParameter::kLeftWheelDiameterUm},
    KeyOnRobot{"right_wheel_diameter_m", RobotParameter::kRightWheelDiameterUm},
    KeyOnRobot{"wheelbase_m", RobotParameter::kWheelbaseUm},
    KeyOnRobot{"ticks_per_revolution", RobotParameter::kTicksPerRevolutionMilli}};

}  // namespace

std::vector<ParameterSet> robotParametersIn(const Calibration& calibration) {
    std::vector<ParameterSet> sets;
    for (const FoundParameter& found : calibration.found) {
        const auto row = std::ranges::find(kKeysOnRobot, found.key, &KeyOnRobot::key);
        if (found.stays || row == kKeysOnRobot.end()) continue;
        const auto meaning = std::ranges::find(kParameterMeanings, row->id, &ParameterMeaning::id);
        const auto raw = parameterOnWire(*meaning, found.now.value);
        if (raw) sets.push_back({static_cast<std::uint8_t>(row->id), *raw});
    }
    return sets;
}

}  // namespace hedr
