#include "core/simulation/packbot_scenario.h"

#include <array>
#include <cmath>
#include <utility>

namespace hedr {

namespace {

using Setting = ScenarioSetting<PackbotScenario>;
constexpr double kDeg = radFromDeg(1.0);

// clang-format off
constexpr std::array kSettings{
    Setting{"duration_s", "length of the mission", [](PackbotScenario& s) -> double& { return s.drive.duration_s; }, 1.0, 1.0, 28800.0},
    Setting{"rate_hz", "reports per second", [](PackbotScenario& s) -> double& { return s.drive.rate_hz; }, 1.0, 5.0, 200.0},
    Setting{"speed_m_s", "speed in a corridor", [](PackbotScenario& s) -> double& { return s.drive.speed_m_s; }, 1.0, 0.1, 1.0},
    Setting{"video_lag_s", "longest age of the picture that the operator steers by", [](PackbotScenario& s) -> double& { return s.drive.video_lag_s; }, 1.0, 0.0, 1.0},
    Setting{"zigzag_deg", "amplitude of the operator's snaking", [](PackbotScenario& s) -> double& { return s.drive.zigzag_rad; }, kDeg, 0.0, 10.0},
    Setting{"standing_start_s", "time to measure the gyro's bias", [](PackbotScenario& s) -> double& { return s.drive.standing_start_s; }, 1.0, 0.0, 600.0},
    Setting{"stop_every_s", "mean time between halts", [](PackbotScenario& s) -> double& { return s.drive.stop_every_s; }, 1.0, 10.0, 1e6},
    Setting{"spin_share", "share of the corners taken on the spot", [](PackbotScenario& s) -> double& { return s.drive.spin_share; }, 1.0, 0.0, 1.0},
    Setting{"goal_after_s", "when he goes to the task or to the diagonal wing, if there is one", [](PackbotScenario& s) -> double& { return s.drive.goal_after_s; }, 1.0, 0.0, 28800.0},
    Setting{"task_s", "length of the task", [](PackbotScenario& s) -> double& { return s.drive.task_s; }, 1.0, 0.0, 28800.0},
    Setting{"building_rotation_deg", "of the building in the world", [](PackbotScenario& s) -> double& { return s.building_rotation_rad; }, kDeg, -180.0, 180.0},
    Setting{"counts_per_revolution", "of the encoders", [](PackbotScenario& s) -> double& { return s.counts_per_revolution; }, 1.0, 1.0, 1e6},
    Setting{"track_slip", "rms share of each track's travel", [](PackbotScenario& s) -> double& { return s.errors.track_slip; }, 1.0, 0.0, 0.5},
    Setting{"turn_slip_spread", "rms share of the track width", [](PackbotScenario& s) -> double& { return s.errors.turn_slip_spread; }, 1.0, 0.0, 0.5},
    Setting{"gyro_bias_deg_s", "largest bias at the start", [](PackbotScenario& s) -> double& { return s.errors.gyro_bias_rad_s; }, kDeg, 0.0, 10.0},
    Setting{"gyro_bias_walk_deg_s_sqrts", "random walk of the bias", [](PackbotScenario& s) -> double& { return s.errors.gyro_bias_walk_rad_s_sqrts; }, kDeg, 0.0, 1.0},
    Setting{"gyro_noise_deg_sqrts", "angle random walk", [](PackbotScenario& s) -> double& { return s.errors.gyro_noise_rad_s_sqrthz; }, kDeg, 0.0, 10.0},
    Setting{"gyro_scale_error", "share of the rate", [](PackbotScenario& s) -> double& { return s.errors.gyro_scale_error; }, 1.0, -0.5, 0.5},
};
// clang-format on

// A PackBot's tracks; the effective width is about 1.45 times the real one of 0.45 m.
Vehicle packbot(const PackbotScenario& scenario) {
    return {.name = "packbot",
            .geometry = {.left_wheel_diameter_m = 0.183,
                         .right_wheel_diameter_m = 0.183,
                         .wheelbase_m = 0.65,
                         .ticks_per_revolution = scenario.counts_per_revolution},
            .gyro_noise_rad_s_sqrthz = scenario.errors.gyro_noise_rad_s_sqrthz,
            .gyro_bias_walk_rad_s_sqrts = scenario.errors.gyro_bias_walk_rad_s_sqrts,
            .max_speed_m_s = 3.0};
}

Building buildingOf(Place place, Random& random) {
    switch (place) {
        case Place::kCorridors:
            return sampleBuilding();
        case Place::kHall:
            return buildingWithHall();
        case Place::kTask:
            return buildingWithTask();
        case Place::kDiagonalWing:
            return buildingWithDiagonalWing();
        case Place::kAslantStart: {
            const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
            return buildingEnteredAslant(side * radFromDeg(random.uniform(8.0, 37.0)));
        }
    }
    return sampleBuilding();
}

Pose<World> inWorld(const Building& building, const Pose<Floor>& pose) {
    return {building.worldFromFloor() * pose.position,
            pose.heading_rad + building.origin.heading_rad};
}

}  // namespace

std::span<const ScenarioSetting<PackbotScenario>> settingsOf(const PackbotScenario&) {
    return kSettings;
}

SimulatedMission simulate(const PackbotScenario& scenario, std::uint64_t seed) {
    Random random(seed);
    SimulatedMission mission;
    mission.vehicle = packbot(scenario);
    Building building = buildingOf(scenario.place, random);
    building.origin.heading_rad = scenario.building_rotation_rad;
    const double rate_hz = scenario.drive.rate_hz;
    const Drive drive = driveThrough(building, scenario.drive, random);
    mission.task_begin_s = drive.task_begin_s;
    mission.task_end_s = drive.task_end_s;
    std::vector<Pose<World>> poses;
    poses.reserve(drive.poses.size());
    mission.truth.reserve(drive.poses.size());
    for (const Pose<Floor>& pose : drive.poses) {
        poses.push_back(inWorld(building, pose));
        mission.truth.push_back(
            {static_cast<double>(mission.truth.size()) / rate_hz, poses.back()});
    }
    mission.sensors =
        sensorReports(poses, rate_hz, mission.vehicle.geometry, scenario.errors, random);
    mission.start = poses.front();
    mission.building = std::move(building);
    return mission;
}

}  // namespace hedr
