#include "core/simulation/scenario.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/robot/sensor_csv.h"
#include "core/site/placement_file.h"
#include "core/site/raster_file.h"
#include "core/text/text_file.h"
#include "core/track/track_file.h"

namespace hedr {

namespace {

constexpr std::array kScenarios{
    ScenarioEntry{"packbot-corridors", "twenty minutes through orthogonal corridors",
                  Place::kCorridors},
    ScenarioEntry{"packbot-hall", "the same, and across a hall off the corridors' directions",
                  Place::kHall},
    ScenarioEntry{"packbot-box", "the same, with five minutes of pushing a box around a square",
                  Place::kTask},
    ScenarioEntry{"packbot-45", "the same, with a wing at 45 degrees", Place::kDiagonalWing},
    ScenarioEntry{"packbot-offset", "the same, from a start that is not parallel to the building",
                  Place::kAslantStart},
};
constexpr double kDeg = kPi / 180.0;

struct Setting {
    std::string_view name;
    std::string_view meaning;
    double& (*value)(Scenario&);
    double unit;  // SI per unit of the key
    double min;
    double max;
};

// clang-format off
constexpr std::array kSettings = {
    Setting{"duration_s", "length of the mission", [](Scenario& s) -> double& { return s.drive.duration_s; }, 1.0, 1.0, 28800.0},
    Setting{"rate_hz", "reports per second", [](Scenario& s) -> double& { return s.drive.rate_hz; }, 1.0, 5.0, 200.0},
    Setting{"speed_m_s", "speed in a corridor", [](Scenario& s) -> double& { return s.drive.speed_m_s; }, 1.0, 0.1, 1.0},
    Setting{"zigzag_deg", "amplitude of the operator's snaking", [](Scenario& s) -> double& { return s.drive.zigzag_rad; }, kDeg, 0.0, 10.0},
    Setting{"video_lag_s", "longest lag of the operator's camera picture", [](Scenario& s) -> double& { return s.drive.video_lag_s; }, 1.0, 0.0, 2.0},
    Setting{"standing_start_s", "time to measure the gyro's bias", [](Scenario& s) -> double& { return s.drive.standing_start_s; }, 1.0, 0.0, 600.0},
    Setting{"stop_every_s", "mean time between halts", [](Scenario& s) -> double& { return s.drive.stop_every_s; }, 1.0, 10.0, 1e6},
    Setting{"spin_share", "share of the corners taken on the spot", [](Scenario& s) -> double& { return s.drive.spin_share; }, 1.0, 0.0, 1.0},
    Setting{"task_after_s", "when he goes to the task, if there is one", [](Scenario& s) -> double& { return s.drive.task_after_s; }, 1.0, 0.0, 28800.0},
    Setting{"task_s", "length of the task", [](Scenario& s) -> double& { return s.drive.task_s; }, 1.0, 0.0, 28800.0},
    Setting{"building_rotation_deg", "of the building in the world", [](Scenario& s) -> double& { return s.building_rotation_rad; }, kDeg, -180.0, 180.0},
    Setting{"counts_per_revolution", "of the encoders", [](Scenario& s) -> double& { return s.counts_per_revolution; }, 1.0, 1.0, 1e6},
    Setting{"track_slip", "rms share of each track's travel", [](Scenario& s) -> double& { return s.errors.track_slip; }, 1.0, 0.0, 0.5},
    Setting{"turn_slip_spread", "rms share of the track width", [](Scenario& s) -> double& { return s.errors.turn_slip_spread; }, 1.0, 0.0, 0.5},
    Setting{"gyro_bias_deg_s", "largest bias at the start", [](Scenario& s) -> double& { return s.errors.gyro_bias_rad_s; }, kDeg, 0.0, 10.0},
    Setting{"gyro_bias_walk_deg_s_sqrts", "random walk of the bias", [](Scenario& s) -> double& { return s.errors.gyro_bias_walk_rad_s_sqrts; }, kDeg, 0.0, 1.0},
    Setting{"gyro_noise_deg_sqrts", "angle random walk", [](Scenario& s) -> double& { return s.errors.gyro_noise_rad_s_sqrthz; }, kDeg, 0.0, 10.0},
    Setting{"gyro_scale_error", "share of the rate", [](Scenario& s) -> double& { return s.errors.gyro_scale_error; }, 1.0, -0.5, 0.5},
};
// clang-format on

std::string plain(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string joined(const auto& named) {
    std::string list;
    for (const auto& item : named) list += (list.empty() ? "" : ", ") + std::string(item.name);
    return list;
}

// A PackBot's tracks; the effective width is about 1.45 times the real one of 0.45 m.
Vehicle packbot(const Scenario& scenario) {
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

std::vector<ScenarioKey> scenarioKeys() {
    Scenario defaults;
    std::vector<ScenarioKey> keys;
    keys.reserve(kSettings.size());
    for (const Setting& s : kSettings) {
        keys.push_back({s.name, s.meaning, s.value(defaults) / s.unit, s.min, s.max});
    }
    return keys;
}

std::span<const ScenarioEntry> scenarioTable() { return kScenarios; }

Result<Scenario> scenarioByName(std::string_view name) {
    for (const ScenarioEntry& entry : kScenarios) {
        if (entry.name == name) return Scenario{.place = entry.place};
    }
    return fail(ErrorCode::kUnknownName, std::string(name),
                "known scenarios: " + joined(kScenarios));
}

Result<void> setScenarioValue(Scenario& scenario, std::string_view key, std::string_view value) {
    for (const Setting& setting : kSettings) {
        if (setting.name != key) continue;
        double number = 0.0;
        const auto [end, error] =
            std::from_chars(value.data(), value.data() + value.size(), number);
        const bool is_number = error == std::errc{} && end == value.data() + value.size();
        if (!is_number || !(number >= setting.min && number <= setting.max)) {
            return fail(ErrorCode::kBadValue, std::string(key),
                        "is \"" + std::string(value) + "\", must be a number from " +
                            plain(setting.min) + " to " + plain(setting.max));
        }
        setting.value(scenario) = number * setting.unit;
        return {};
    }
    return fail(ErrorCode::kUnknownName, std::string(key), "known keys: " + joined(kSettings));
}

SimulatedMission simulate(const Scenario& scenario, std::uint64_t seed) {
    Random random(seed);
    SimulatedMission mission;
    mission.vehicle = packbot(scenario);
    mission.building = buildingOf(scenario.place, random);
    mission.building.origin.heading_rad = scenario.building_rotation_rad;
    const double rate_hz = scenario.drive.rate_hz;
    const Drive drive = driveThrough(mission.building, scenario.drive, random);
    mission.task_begin_s = drive.task_begin_s;
    mission.task_end_s = drive.task_end_s;
    std::vector<Pose<World>> poses;
    poses.reserve(drive.poses.size());
    mission.truth.reserve(drive.poses.size());
    for (const Pose<Floor>& pose : drive.poses) {
        poses.push_back(inWorld(mission.building, pose));
        mission.truth.push_back(
            {static_cast<double>(mission.truth.size()) / rate_hz, poses.back()});
    }
    mission.sensors =
        sensorReports(poses, rate_hz, mission.vehicle.geometry, scenario.errors, random);
    mission.start = poses.front();
    return mission;
}

Result<void> writeMission(const SimulatedMission& mission, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(ErrorCode::kFileUnwritable, folder.string(), error.message());
    const auto write_plan = [&] {
        const PlanImage plan = planOf(mission.building);
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
