#include "core/simulation/scenario.h"

#include <array>
#include <string>

#include "core/text/number.h"

namespace hedr {

namespace {

template <class Kind>
Scenario byDefault() {
    return Kind{};
}

constexpr std::array kScenarios{
    ScenarioEntry{"packbot-corridors", "twenty minutes through orthogonal corridors",
                  []() -> Scenario { return PackbotScenario{.place = Place::kCorridors}; }},
    ScenarioEntry{"packbot-hall", "the same, and across a hall off the corridors' directions",
                  []() -> Scenario { return PackbotScenario{.place = Place::kHall}; }},
    ScenarioEntry{"packbot-box", "the same, with five minutes of pushing a box around a square",
                  []() -> Scenario { return PackbotScenario{.place = Place::kTask}; }},
    ScenarioEntry{"packbot-45", "the same, with a wing at 45 degrees",
                  []() -> Scenario { return PackbotScenario{.place = Place::kDiagonalWing}; }},
    ScenarioEntry{"packbot-offset", "the same, from a start that is not parallel to the building",
                  []() -> Scenario { return PackbotScenario{.place = Place::kAslantStart}; }},
    ScenarioEntry{"labmate-bumps", "a LabMate drives straight over 15 cables",
                  byDefault<LabmateBumps>},
    ScenarioEntry{"gyrostar-warmup", "ten minutes of a heavy vehicle while its gyro warms up",
                  byDefault<GyrostarWarmup>},
    ScenarioEntry{"romi-rectangle", "a Romi follows a rectangle beside magnetic iron",
                  byDefault<RomiRectangle>},
    ScenarioEntry{"umbmark", "five squares clockwise and five counter-clockwise",
                  byDefault<UmbmarkSquares>},
};

std::string joined(const auto& named) {
    std::string list;
    for (const auto& item : named) list += (list.empty() ? "" : ", ") + std::string(item.name);
    return list;
}

template <class Kind>
Result<void> set(Kind& scenario, const ScenarioSetting<Kind>& setting, std::string_view text) {
    const auto number = parseNumber(text);
    if (!number || !(*number >= setting.min && *number <= setting.max)) {
        std::string detail = "is \"" + std::string(text) + "\", must be a number from ";
        appendNumber(detail, setting.min);
        appendNumber(detail += " to ", setting.max);
        return fail(ErrorCode::kBadValue, std::string(setting.name), detail);
    }
    setting.value(scenario) = *number * setting.unit;
    return {};
}

}  // namespace

std::span<const ScenarioEntry> scenarioTable() { return kScenarios; }

std::vector<ScenarioKey> scenarioKeys(const Scenario& scenario) {
    std::vector<ScenarioKey> keys;
    std::visit(
        [&keys](auto each) {
            for (const auto& setting : settingsOf(each)) {
                keys.push_back({setting.name, setting.meaning, setting.value(each) / setting.unit,
                                setting.min, setting.max});
            }
        },
        scenario);
    return keys;
}

Result<Scenario> scenarioByName(std::string_view name) {
    for (const ScenarioEntry& entry : kScenarios) {
        if (entry.name == name) return entry.make();
    }
    return fail(ErrorCode::kUnknownName, std::string(name),
                "known scenarios: " + joined(kScenarios));
}

Result<void> setScenarioValue(Scenario& scenario, std::string_view key, std::string_view value) {
    return std::visit(
        [&](auto& each) -> Result<void> {
            for (const auto& setting : settingsOf(each)) {
                if (setting.name == key) return set(each, setting, value);
            }
            return fail(ErrorCode::kUnknownName, std::string(key),
                        "known keys: " + joined(settingsOf(each)));
        },
        scenario);
}

SimulatedMission simulate(const Scenario& scenario, std::uint64_t seed) {
    return std::visit([seed](const auto& each) { return simulate(each, seed); }, scenario);
}

}  // namespace hedr
