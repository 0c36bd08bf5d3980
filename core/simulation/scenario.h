#pragma once

#include <cstdint>
#include <filesystem>
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

struct Scenario {
    DriveStyle drive{};
    SensorErrors errors{};
    double counts_per_revolution = 36.0;
    double building_rotation_rad = 0.0;
};

struct ScenarioKey {
    std::string_view name;
    std::string_view meaning;
    double default_value = 0.0;
    double min = 0.0;
    double max = 0.0;
};

// What `--set KEY=VALUE` takes, with the defaults of packbot-corridors.
std::vector<ScenarioKey> scenarioKeys();
std::vector<std::string> scenarioNames();

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
};

// The same seed gives the same mission on every machine.
SimulatedMission simulate(const Scenario& scenario, std::uint64_t seed);

// Writes sensors.csv, truth.csv, vehicle.toml, plan.png and plan.toml into `folder`, which is made
// where it is missing. Errors: kFileUnwritable, kDiskFull.
Result<void> writeMission(const SimulatedMission& mission, const std::filesystem::path& folder);

}  // namespace hedr
