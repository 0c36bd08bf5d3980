#pragma once

#include <span>
#include <string>

#include "core/calibration/gyro/gyro_stands.h"

namespace hedr {

// Whether the gyro was at the end of its range while it turned: at its fastest it stays equal for
// much longer than it ever does while it stands.
bool isBeyondRange(std::span<const GyroSample> samples, const GyroStands& standing);

// Whether a standing gyro is at the end of its range: readings pile up at their largest or smallest
// value, which noise alone never makes them do. With fewer than six values it is coarse instead.
bool isClipped(std::span<const GyroSample> samples);

// Why readings of a standing gyro that are clipped are no basis; empty: they are not.
std::string complaintAboutClipped(std::span<const GyroSample> samples);

// The share of readings that are equal to the most common one.
double shareOfCommonest(std::span<const GyroSample> samples);

}  // namespace hedr
