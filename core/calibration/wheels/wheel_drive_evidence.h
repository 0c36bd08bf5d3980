#pragma once

#include "core/calibration/wheels/wheel_drive.h"

namespace hedr {

// What the operator sees of the drives so far: fills steps, progress, figures, remarks and plots of
// wheels.calibration from the rest of it. `unsure_share`: as in DriveFitOptions.
void addEvidence(WheelDrive& wheels, const VehicleGeometry& believed, double unsure_share,
                 const WheelDriveOptions& options);

}  // namespace hedr
