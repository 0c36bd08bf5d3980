#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "core/simulation/gyrostar_warmup.h"
#include "core/simulation/labmate_bumps.h"
#include "core/simulation/packbot_scenario.h"
#include "core/simulation/romi_rectangle.h"
#include "core/simulation/umbmark_squares.h"

namespace hedr {

using Scenario =
    std::variant<PackbotScenario, LabmateBumps, GyrostarWarmup, RomiRectangle, UmbmarkSquares>;

struct ScenarioEntry {
    std::string_view name;
    std::string_view meaning;
    Scenario (*make)();
};

// The one table of scenarios.
std::span<const ScenarioEntry> scenarioTable();

struct ScenarioKey {
    std::string_view name;
    std::string_view meaning;
    double value = 0.0;  // what the scenario has now
    double min = 0.0;
    double max = 0.0;
};

// What `--set KEY=VALUE` takes for this kind of scenario.
std::vector<ScenarioKey> scenarioKeys(const Scenario& scenario);

// Errors: kUnknownName, listing the known ones.
Result<Scenario> scenarioByName(std::string_view name);

// Errors: kUnknownName (listing the scenario's keys), kBadValue (not a number, or out of range).
Result<void> setScenarioValue(Scenario& scenario, std::string_view key, std::string_view value);

// The same seed gives the same mission on every machine.
SimulatedMission simulate(const Scenario& scenario, std::uint64_t seed);

}  // namespace hedr
