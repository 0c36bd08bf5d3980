#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/sample_set.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct StraightRun {
    std::size_t number = 0;  // in their order, from 1, those that are left out too
    double way_m = 0.0;      // by the believed wheels, signed
};

struct StraightRuns {
    std::vector<StraightRun> runs{};
    Calibration calibration{};
};

// The size of the wheels from straight runs of a known length, to and fro if you like: a log each,
// or one in which the robot stands for two seconds or more between them. Both diameters change
// alike, and the wheelbase with them, so that turns stay as they are. Refused, with the reason, are
// a length of nothing, missing encoders, and runs none of which is straight and about that long.
StraightRuns calibrateByStraightRuns(std::span<const SampleSet> sets, const Vehicle& believed,
                                     double distance_m);

}  // namespace hedr
