#pragma once

#include <cstdint>
#include <span>

#include "core/simulation/scenario_setting.h"
#include "core/simulation/simulated_mission.h"

namespace hedr {

// UMBmark (Borenstein, Feng, "Measurement and Correction of Systematic Odometry Errors in Mobile
// Robots", 1996): a LabMate drives five squares clockwise and five counter-clockwise by its own
// odometry, which has two errors. Each square begins and ends with a pause of `pause_s`; a corner's
// stop is at most kUmbmarkCornerStop_s. The robot is not put back between them, so a square counts
// from the pose in the pause before it.
struct UmbmarkSquares {
    double side_m = 4.0;
    double diameter_ratio = 1.002;     // E_d, right wheel over left
    double wheelbase_ratio = 1.005;    // E_b, real over believed
    double unevenness_m_sqrtm = 1e-4;  // rms error of a wheel's travel after one metre
    double speed_m_s = 0.2;
    double pause_s = 5.0;
};

inline constexpr double kUmbmarkCornerStop_s = 1.0;
inline constexpr int kUmbmarkSquaresEachWay = 5;

std::span<const ScenarioSetting<UmbmarkSquares>> settingsOf(const UmbmarkSquares& scenario);
SimulatedMission simulate(const UmbmarkSquares& scenario, std::uint64_t seed);

}  // namespace hedr
