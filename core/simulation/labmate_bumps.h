#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/angle.h"
#include "core/simulation/scenario_setting.h"
#include "core/simulation/simulated_mission.h"

namespace hedr {

// The experiment of Figs. 2 and 4 in Borenstein and Feng, "Gyrodometry", 1996: a LabMate drives
// straight for 140 s at 0.1 m/s over 15 cables that lie under its right wheel. Its controller keeps
// the encoders equal, so that they do not see the way that is lost at a cable. The model is told in
// docs/reproduction.md.
struct LabmateBumps {
    // How far the heading is off when a cable of 6, 9, 12 mm has been crossed.
    double residual_6mm_rad = radFromDeg(0.4);
    double residual_9mm_rad = radFromDeg(0.6);
    double residual_12mm_rad = radFromDeg(0.8);
    double swerve_rad = radFromDeg(0.5);  // to and fro, which the encoders see too
    double held_share = 1.0;              // of its speed, lost by a wheel until it climbs a cable
    double gyro_drift_rad_s = radFromDeg(0.03);  // to either side
    double gyro_noise_rad_s_sqrthz = radFromDeg(0.035);
    double unevenness_m_sqrtm = 0.0;  // rms error of a wheel's travel after one metre
};

std::span<const ScenarioSetting<LabmateBumps>> settingsOf(const LabmateBumps& scenario);
SimulatedMission simulate(const LabmateBumps& scenario, std::uint64_t seed);

}  // namespace hedr
