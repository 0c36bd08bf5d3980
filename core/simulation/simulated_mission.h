#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/robot/report.h"
#include "core/robot/vehicle.h"
#include "core/simulation/building.h"
#include "core/track/track.h"

namespace hedr {

struct SimulatedMission {
    Vehicle vehicle{};  // what the software believes of the robot
    std::vector<SensorReport> sensors{};
    std::vector<TrackPoint> truth{};  // one per report, heading not wrapped
    std::optional<Building> building{};
    Pose<World> start{};
    double task_begin_s = 0.0;  // both 0 without a task
    double task_end_s = 0.0;
};

// Writes sensors.csv, truth.csv, vehicle.toml and, where there is a building, plan.png and
// plan.toml into `folder`, which is made where it is missing. Errors: kFileUnwritable, kDiskFull.
Result<void> writeMission(const SimulatedMission& mission, const std::filesystem::path& folder);

}  // namespace hedr
