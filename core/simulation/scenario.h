#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot/report.h"
#include "core/robot/vehicle.h"
#include "core/simulation/building.h"
#include "core/simulation/drive.h"
#include "core/simulation/sensor_errors.h"
#include "core/track/track.h"

namespace hedr {

// What a PackBot is sent through.
enum class Place { kCorridors, kHall, kTask, kDiagonalWing, kAslantStart };

struct Scenario {
    Place place = Place::kCorridors;
    DriveStyle drive{};
    SensorErrors errors{};
    double counts_per_revolution = 36.0;
    double building_rotation_rad = 0.0;
};

struct ScenarioEntry {
    std::string_view name;
    std::string_view meaning;
    Place place = Place::kCorridors;
};

// The one table of scenarios.
std::span<const ScenarioEntry> scenarioTable();

struct ScenarioKey {
    std::string_view name;
    std::string_view meaning;
    double default_value = 0.0;
    double min = 0.0;
    double max = 0.0;
};

// What `--set KEY=VALUE` takes, with the defaults.
std::vector<ScenarioKey> scenarioKeys();

// Errors: kUnknownName, listing the known ones.
Result<Scenario> scenarioByName(std::string_view name);

// Errors: kUnknownName (listing the known keys), kBadValue (not a number, or out of range).
Result<void> setScenarioValue(Scenario& scenario, std::string_view key, std::string_view value);

struct SimulatedMission {
    Vehicle vehicle{};
    std::vector<SensorReport> sensors;
    std::vector<TrackPoint> truth;  // one per report, heading not wrapped
    Building building;
    Pose<World> start{};
    double task_begin_s = 0.0;  // both 0 without a task
    double task_end_s = 0.0;
};

// The same seed gives the same mission on every machine.
SimulatedMission simulate(const Scenario& scenario, std::uint64_t seed);

// Writes sensors.csv, truth.csv, vehicle.toml, plan.png and plan.toml into `folder`, which is made
// where it is missing. Errors: kFileUnwritable, kDiskFull.
Result<void> writeMission(const SimulatedMission& mission, const std::filesystem::path& folder);

}  // namespace hedr
