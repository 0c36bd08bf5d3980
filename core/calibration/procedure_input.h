#pragma once

#include <optional>
#include <vector>

#include "core/calibration/sample_set.h"
#include "core/calibration/squares/umbmark_ends.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What the operator knows besides the samples.
struct ProcedureSettings {
    std::optional<double> turns{};       // whole ones, of each stretch of turning; none: counted
    bool closed = false;                 // each record ended heading as it began, drives also there
    std::optional<double> distance_m{};  // that it was pushed, or of each straight run
    double on_before_s = 0.0;            // the gyro was switched on so long before the record began
    bool room_changes = false;           // its temperature may, while the gyro warms up
    std::vector<UmbmarkEnd> ends{};      // of square drives, by tape or from the map

    friend bool operator==(const ProcedureSettings&, const ProcedureSettings&) = default;
};

struct ProcedureInput {
    std::vector<SampleSet> sets{};
    Vehicle vehicle{};  // as it is believed
    ProcedureSettings settings{};
};

}  // namespace hedr
