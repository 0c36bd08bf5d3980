#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/gyro_samples.h"

namespace hedr {

// A part of the time that a gyro stood still.
struct GyroBiasPart {
    double mean_rad_s = 0.0;
    double span_s = 0.0;
    double middle_s = 0.0;
    std::size_t outliers = 0;
};

struct GyroBiasFit {
    Estimate mean_rad_s{};
    Estimate drift_rad_s2{};
    Estimate noise_rad_s_sqrthz{};
    std::size_t outliers = 0;  // left out
    std::vector<GyroBiasPart> parts{};
};

inline constexpr std::size_t kFewestGyroBiasReadings = 90;

// What a standing gyro says, at least kFewestGyroBiasReadings. The mean is that of the parts; its
// error is how far these are from a straight line over time, so that a bias that drifts while it is
// measured does not count as noise. Readings far from the others of their part are left out.
GyroBiasFit fitGyroBias(std::span<const GyroSample> standing, double period_s);

// How long it is worth to stand until a mean has that standard error: not longer than it takes
// until the Allan deviation of these readings, as far as they tell, is twice that of white noise.
// Within sensible limits.
double standingNeeded_s(std::span<const GyroSample> standing, double noise_rad_s_sqrthz,
                        double wanted_rad_s);

}  // namespace hedr
