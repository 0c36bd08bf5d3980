#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/gyro/allan_deviation.h"

namespace hedr {

// One coefficient of a gyro's noise. Where a record cannot tell it there is only a bound.
struct NoiseCoefficient {
    std::optional<Estimate> found{};
    Interval interval{};  // 95 %; from 0 where it is not found
};

// The three slopes of an Allan deviation: IEEE Std 952, Annex C.
struct GyroNoiseFit {
    NoiseCoefficient angle_walk_rad_s_sqrthz{};  // N, slope -1/2
    NoiseCoefficient instability_rad_s{};        // B, the flat part is 0.664 B
    NoiseCoefficient rate_walk_rad_s_sqrts{};    // K, slope +1/2
    double fitted_from_s = 0.0;                  // shorter ones are those of a filter in the gyro
    double fitted_to_s = 0.0;

    double deviation(double tau_s) const;  // of the three together
};

// Fits the squares of deviations of one record. Each is as sure as the noise that was found makes
// it, and so is how they go together: the covariance of two Allan variances is the integral of the
// squared spectrum, seen through both windows. None where fewer than three points tell anything.
std::optional<GyroNoiseFit> fitGyroNoise(std::span<const AllanPoint> points, double period_s);

}  // namespace hedr
