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

std::vector<ParameterSet> robotParametersIn(const Calibration& calibration,
                                            const Vehicle& believed) {
    const bool tells = std::ranges::any_of(calibration.found, [](const FoundParameter& found) {
        return !found.stays &&
               std::ranges::find(kKeysOnRobot, found.key, &KeyOnRobot::key) != kKeysOnRobot.end();
    });
    const auto vehicle = calibrated(believed, calibration);
    if (!tells || !vehicle) return {};
    std::vector<ParameterSet> sets;
    for (const KeyOnRobot& row : kKeysOnRobot) {
        const auto meaning = std::ranges::find(kParameterMeanings, row.id, &ParameterMeaning::id);
        const auto value = vehicleNumber(*vehicle, row.key);
        const auto raw = value ? parameterOnWire(*meaning, *value) : std::nullopt;
        if (!raw) return {};
        sets.push_back({static_cast<std::uint8_t>(row.id), *raw});
    }
    return sets;
}

}  // namespace hedr
