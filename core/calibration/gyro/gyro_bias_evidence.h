#pragma once

#include <cstddef>

#include "core/calibration/gyro/gyro_bias.h"

namespace hedr {

// What the operator sees of the measurement so far: fills progress, steps, figures, remarks and
// plot of bias.calibration from the rest of it. `outliers`: readings that were left out.
void addEvidence(GyroBias& bias, const GyroSamples& gyro, const Stillness& stillness,
                 std::size_t outliers, double gyro_scale, double wanted_standard_error_rad_s);

std::vector<CalibrationStep> gyroBiasSteps(const GyroBias& bias);

}  // namespace hedr
