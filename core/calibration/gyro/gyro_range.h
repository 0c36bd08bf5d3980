#pragma once

#include <span>

#include "core/calibration/gyro/gyro_stands.h"

namespace hedr {

// Whether the gyro was at the end of its range while it turned: at its fastest it stays equal for
// much longer than it ever does while it stands.
bool isBeyondRange(std::span<const GyroSample> samples, const GyroStands& standing);

}  // namespace hedr
