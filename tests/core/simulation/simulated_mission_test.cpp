#include "core/simulation/simulated_mission.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/robot/sensor_csv.h"
#include "core/simulation/scenario.h"
#include "core/track/track_file.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

TEST(WriteMission, WritesFilesThatReadBackAsTheMission) {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch.path() / "mission";
    const SimulatedMission mission = simulate(
        PackbotScenario{.drive = {.duration_s = 60.0}, .building_rotation_rad = radFromDeg(20.0)},
        8);
    ASSERT_TRUE(writeMission(mission, folder));
    EXPECT_EQ(loadSensorLog(folder / "sensors.csv")->reports, mission.sensors);
    EXPECT_EQ(loadTrack(folder / "truth.csv").value(), mission.truth);
    EXPECT_EQ(loadVehicle(folder / "vehicle.toml").value(), mission.vehicle);
    const auto plan = loadPlan(folder / "plan.toml");
    ASSERT_TRUE(plan);
    EXPECT_NEAR(plan->placement.origin.heading_rad, radFromDeg(20.0), 1e-12);
}

TEST(WriteMission, WritesNoPlanWhereThereIsNoBuilding) {
    const ScratchFolder scratch;
    const SimulatedMission mission = simulate(scenarioByName("romi-rectangle").value(), 1);
    ASSERT_TRUE(writeMission(mission, scratch.path()));
    EXPECT_EQ(loadSensorLog(scratch.path() / "sensors.csv")->reports, mission.sensors);
    EXPECT_EQ(loadVehicle(scratch.path() / "vehicle.toml").value(), mission.vehicle);
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "plan.png"));
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "plan.toml"));
}

TEST(WriteMission, SaysWhereItCannotWrite) {
    const auto result =
        writeMission(simulate(PackbotScenario{.drive = {.duration_s = 1.0}}, 1), "/proc/no/folder");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kFileUnwritable);
    EXPECT_EQ(result.error().subject, "/proc/no/folder");
}

}  // namespace
}  // namespace hedr
