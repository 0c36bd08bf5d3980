#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibration/squares/square_runs.h"
#include "core/calibration/squares/umbmark_ends.h"
#include "core/calibration/squares/umbmark_solution.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct PairedEnds {
    std::vector<MeasuredSquare> squares{};  // they refer to the drives
    std::vector<std::string> remarks{};     // what does not go together, one sentence each
};

// Each square drive with its end; the last one counts where several are given. Left out are ends
// that are no numbers, that were said to be of the other direction, that cannot be in metres, and
// squares that were not closed.
PairedEnds pairedEnds(const SquareRuns& drives, std::span<const UmbmarkEnd> ends,
                      const VehicleGeometry& believed);

}  // namespace hedr
