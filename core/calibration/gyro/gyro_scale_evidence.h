#pragma once

#include <span>
#include <string>

#include "core/calibration/gyro/gyro_scale.h"

namespace hedr {

// What the operator sees of the turns so far: fills steps, progress, figures, remarks and plot of
// scale.calibration from the rest of it.
void addEvidence(GyroScale& scale, std::span<const TurnLog> logs, const Vehicle& believed,
                 double wanted_standard_error);

// "450°".
std::string degreesText(double angle_rad, int digits = 2);

}  // namespace hedr
