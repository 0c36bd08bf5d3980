#pragma once

#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/building.h"
#include "core/simulation/random.h"

namespace hedr {

// How a tele-operator drives.
struct DriveStyle {
    double duration_s = 1200.0;
    double rate_hz = 50.0;
    double speed_m_s = 0.6;
    double zigzag_rad =
        radFromDeg(3.0);             // amplitude (rms times sqrt 2) of the snaking in a corridor
    double video_lag_s = 1.0;        // at most; another one on each leg
    double standing_start_s = 10.0;  // for measuring the gyro's bias
    double stop_every_s = 120.0;     // mean time between two halts of 5 to 20 s
    double spin_share = 0.35;        // of the corners taken on the spot instead of in an arc
    double goal_after_s = 400.0;     // where the building has a goal, he goes there then
    double task_s = 300.0;           // and works so long, if there is a task
};

struct Drive {
    std::vector<Pose<Floor>> poses;
    double task_begin_s = 0.0;  // both 0 without a task
    double task_end_s = 0.0;
};

// The true poses of a drive through the corridors, one every 1/rate_hz from time 0 on. The robot
// wanders without turning back, comes home while the time allows it, and waits there.
Drive driveThrough(const Building& building, const DriveStyle& style, Random& random);

}  // namespace hedr
