#pragma once

#include <span>
#include <vector>

#include "core/calibration/drive_fit.h"

namespace hedr {

// The effective wheelbase in turns of about that rate: tracks slip the more the faster they turn,
// and otherwise on another floor.
struct TrackWidth {
    double rate_rad_s = 0.0;  // mean of the turns, whichever way
    Estimate wheelbase_m{};
    std::size_t turns = 0;
};

// The turns of a drive in up to five classes of their rate, as many in each; empty: too few.
std::vector<TrackWidth> trackWidths(std::span<const DriveLog> logs, const DriveFit& fit);

// Of one turn: what the wheels' difference is to what the robot turned.
double wheelbaseInTurn_m(const DrivePiece& turn, double turned_rad, double right_larger);

inline constexpr double kClearTurn_rad = 0.5;  // less does not tell a wheelbase

}  // namespace hedr
