#pragma once

#include <span>

#include "core/calibration/compass/magnetometer.h"

namespace hedr {

// What the operator sees so far: fills steps, progress, figures, remarks and plots of
// result.calibration from the rest of it.
void addEvidence(MagnetometerCalibration& result, std::span<const MagneticLog> logs,
                 const Vehicle& believed);

}  // namespace hedr
