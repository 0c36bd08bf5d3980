#include "core/simulation/simulated_mission.h"

#include "core/robot/sensor_csv.h"
#include "core/site/placement_file.h"
#include "core/site/raster_file.h"
#include "core/text/text_file.h"
#include "core/track/track_file.h"

namespace hedr {

Result<void> writeMission(const SimulatedMission& mission, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(ErrorCode::kFileUnwritable, folder.string(), error.message());
    const auto write_plan = [&]() -> Result<void> {
        if (!mission.building) return {};
        const PlanImage plan = planOf(*mission.building);
        return savePlanImage(plan.levels.front(), folder / "plan.png").and_then([&] {
            return savePlacement({"plan.png", plan.placement}, folder / "plan.toml");
        });
    };
    return saveSensorLog(folder / "sensors.csv", mission.sensors)
        .and_then([&] { return saveTrack(folder / "truth.csv", mission.truth); })
        .and_then(
            [&] { return writeTextFile(folder / "vehicle.toml", formatVehicle(mission.vehicle)); })
        .and_then(write_plan);
}

}  // namespace hedr
