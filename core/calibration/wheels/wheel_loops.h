#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/sample_set.h"
#include "core/calibration/wheels/drive_rows.h"
#include "core/geometry/frames.h"
#include "core/robot/vehicle.h"

namespace hedr {

// A drive that ended where it began, heading as it began.
struct DrivenLoop {
    std::size_t set = 0;  // of the samples
    double rolled_m = 0.0;
    double turned_rad = 0.0;  // whole turns
    // Where it ended by the wheels, seen from where it began: by the believed ones, and by those
    // that the other loops give.
    Pose<Robot> before{};
    Pose<Robot> after{};
};

struct WheelLoops {
    std::vector<DrivenLoop> loops{};
    WheelShape shape{};
    Calibration calibration{};
};

inline constexpr std::size_t kFewestLoops = 4;

// Effective wheelbase and ratio of the wheels from drives that ended where they began: least
// squares of how far the wheels' own dead-reckoning is from its start at each end. Needs no gyro;
// where there is one it says how many turns a loop had. Standard errors and proof leave out one
// loop each. Refused, with the reason, are encoders that do not tell the sides, fewer than
// kFewestLoops loops, and loops that only turn one way, in which a wrong wheelbase and unequal
// wheels hide each other.
WheelLoops calibrateByLoops(std::span<const SampleSet> sets, const Vehicle& believed);

}  // namespace hedr
