#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/angle.h"
#include "core/simulation/scenario_setting.h"
#include "core/simulation/simulated_mission.h"

namespace hedr {

// The vehicle experiment of Barshan and Durrant-Whyte, "Orientation Estimate for Mobile Robots
// using Gyroscopic Information", 1994: a heavy vehicle stands for 2,000 samples of 30 ms, drives
// forth and back along a line, then around, while its Gyrostar warms up: the bias is
// C1 (1 - exp(-t/T)) + C2.
struct GyrostarWarmup {
    double c1_rad_s = radFromDeg(0.153);
    double c2_rad_s = radFromDeg(-0.264);
    double time_constant_s = 60.0 * 5.64;
    // Share by which today's C1, C2, T may differ from the vehicle file's: about what white noise
    // of 0.2 degrees per second leaves of them in a log of half an hour at rest.
    double drift_spread = 0.01;
    double gyro_noise_rad_s = radFromDeg(0.2);  // per sample of 30 ms
    double warm_for_s = 0.0;                    // the gyro has been on before the log begins
    double standing_start_s = 60.0;
    double drive_s = 600.0;
};

std::span<const ScenarioSetting<GyrostarWarmup>> settingsOf(const GyrostarWarmup& scenario);
SimulatedMission simulate(const GyrostarWarmup& scenario, std::uint64_t seed);

}  // namespace hedr
