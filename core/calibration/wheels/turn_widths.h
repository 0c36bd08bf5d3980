#pragma once

#include <span>
#include <vector>

#include "core/calibration/track_width.h"
#include "core/calibration/wheels/drive_fit.h"

namespace hedr {

// One turn that slipped no more than others: what the wheels' difference is to what it turned.
struct TurnWidth {
    double rate_rad_s = 0.0;  // whichever way
    double wheelbase_m = 0.0;
};

// Of the turns that are large enough to tell; none without a fit.
std::vector<TurnWidth> turnWidths(std::span<const DriveLog> logs, const DriveFit& fit);

// The turns of a drive in up to five classes of their rate, as many in each; empty: too few.
std::vector<TrackWidth> trackWidths(std::span<const DriveLog> logs, const DriveFit& fit);

}  // namespace hedr
