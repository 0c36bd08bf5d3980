#pragma once

#include <string_view>

#include "core/calibration/wheel_drive.h"

namespace hedr {

// The title of the plot of the wheelbase against the rate of turn.
inline constexpr std::string_view kTrackWidthPlot = "Wheelbase in each turn";

// What the operator sees of the drives so far: fills steps, progress, figures, remarks and plots of
// wheels.calibration from the rest of it. `unsure_share`: as in DriveFitOptions.
void addEvidence(WheelDrive& wheels, const VehicleGeometry& believed, double unsure_share,
                 const WheelDriveOptions& options);

}  // namespace hedr
