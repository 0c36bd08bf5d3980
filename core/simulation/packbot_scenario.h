#pragma once

#include <cstdint>
#include <span>

#include "core/simulation/drive.h"
#include "core/simulation/scenario_setting.h"
#include "core/simulation/sensor_errors.h"
#include "core/simulation/simulated_mission.h"

namespace hedr {

// What a PackBot is sent through.
enum class Place { kCorridors, kHall, kTask, kDiagonalWing, kAslantStart };

// A tele-operated, tracked PackBot in the sample building.
struct PackbotScenario {
    Place place = Place::kCorridors;
    DriveStyle drive{};
    SensorErrors errors{};
    double counts_per_revolution = 36.0;
    double building_rotation_rad = 0.0;
};

std::span<const ScenarioSetting<PackbotScenario>> settingsOf(const PackbotScenario& scenario);
SimulatedMission simulate(const PackbotScenario& scenario, std::uint64_t seed);

}  // namespace hedr
