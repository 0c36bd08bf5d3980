#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/calibration/wheels/wheel_drive.h"
#include "core/geometry/angle.h"
#include "core/simulation/packbot_scenario.h"
#include "core/simulation/random.h"

namespace hedr::test {

// A PackBot in the corridors of the sample building, and what is wrong with it. Its wheels are
// alike and its wheelbase is 0.65 m.
struct DriveBench {
    const char* name = "";
    double duration_s = 1200.0;
    double believed_wheelbase_m = 0.65;
    double believed_right_larger = 0.0;
    double track_slip = 0.03;
    double turn_slip_spread = 0.07;
    double gyro_scale = 1.0;   // believed; other than one: it was calibrated
    double scale_error = 0.0;  // of the gyro
    double stop_every_s = 120.0;
    double standing_start_s = 10.0;
    double ramp_deg_s_per_min = 0.0;  // of the gyro's bias
    double spins_per_min = 0.0;       // a track spins for a second, by up to its own way once more
    double lost_share = 0.0;          // of the reports

    static constexpr double kWheelbase_m = 0.65;
    // What the wheels are against those believed.
    double rightLarger() const { return -believed_right_larger; }
};

inline Vehicle believedBy(const DriveBench& bench, const Vehicle& real) {
    Vehicle vehicle = real;
    vehicle.gyro_scale = bench.gyro_scale;
    vehicle.geometry.wheelbase_m = bench.believed_wheelbase_m;
    vehicle.geometry.left_wheel_diameter_m *= 1.0 - 0.5 * bench.believed_right_larger;
    vehicle.geometry.right_wheel_diameter_m *= 1.0 + 0.5 * bench.believed_right_larger;
    return vehicle;
}

struct DriveOnBench {
    Vehicle believed{};
    std::vector<SampleSet> sets{};
};

// A track that spins counts more than it gets on.
inline void addSpins(std::vector<SensorReport>& reports, double spins_per_min, Random& random) {
    if (spins_per_min == 0.0) return;
    double next_s = random.uniform(0.0, 120.0 / spins_per_min);
    double until_s = 0.0;
    double factor = 0.0;
    bool left = false;
    WheelTicks more{};
    double more_left = 0.0, more_right = 0.0;
    WheelTicks before = std::get<WheelTicks>(reports.front().odometry);
    for (SensorReport& report : reports) {
        auto& ticks = std::get<WheelTicks>(report.odometry);
        const WheelTicks now = ticks;
        if (report.robot_time_s > next_s) {
            left = random.uniform() < 0.5;
            factor = random.uniform(0.2, 1.0);
            until_s = report.robot_time_s + 1.0;
            next_s = report.robot_time_s + 1.0 + random.uniform(0.0, 120.0 / spins_per_min);
        }
        if (report.robot_time_s < until_s) {
            double& counts = left ? more_left : more_right;
            counts += factor *
                      static_cast<double>(left ? now.left - before.left : now.right - before.right);
        }
        more = {static_cast<std::int64_t>(std::floor(more_left)),
                static_cast<std::int64_t>(std::floor(more_right))};
        ticks = {now.left + more.left, now.right + more.right};
        before = now;
    }
}

inline DriveOnBench driven(const DriveBench& bench, std::uint64_t seed) {
    PackbotScenario scenario;
    scenario.drive.duration_s = bench.duration_s;
    scenario.drive.stop_every_s = bench.stop_every_s;
    scenario.drive.standing_start_s = bench.standing_start_s;
    scenario.drive.rate_hz = 25.0;
    scenario.errors.track_slip = bench.track_slip;
    scenario.errors.turn_slip_spread = bench.turn_slip_spread;
    scenario.errors.gyro_scale_error = bench.scale_error;
    SimulatedMission mission = simulate(scenario, seed);
    Random random(seed + 777);
    addSpins(mission.sensors, bench.spins_per_min, random);
    std::vector<SensorReport> reports;
    for (SensorReport& report : mission.sensors) {
        auto& rate_rad_s = std::get<GyroRate>(report.gyro).rad_s;
        rate_rad_s += radFromDeg(bench.ramp_deg_s_per_min) / 60.0 * report.robot_time_s;
        rate_rad_s /= bench.gyro_scale;
        if (random.uniform() >= bench.lost_share) reports.push_back(report);
    }
    DriveOnBench drive{.believed = believedBy(bench, mission.vehicle)};
    drive.sets.push_back({"simulated", std::move(reports)});
    return drive;
}

inline WheelDrive calibratedOn(const DriveBench& bench, std::uint64_t seed) {
    const DriveOnBench drive = driven(bench, seed);
    return calibrateByDriving(drive.sets, drive.believed);
}

}  // namespace hedr::test
