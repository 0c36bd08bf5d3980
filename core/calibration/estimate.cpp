#include "core/calibration/estimate.h"

#include <cmath>
#include <limits>

#include "core/calibration/distributions.h"

namespace hedr {

double Estimate::margin(double confidence) const {
    if (!(degrees_of_freedom > 0.0)) return std::numeric_limits<double>::infinity();
    return studentQuantile(0.5 + 0.5 * confidence, degrees_of_freedom) * standard_error;
}

Interval Estimate::interval(double confidence) const {
    const double half = margin(confidence);
    return {value - (1.0 - lopsided) * half, value + (1.0 + lopsided) * half};
}

bool Estimate::isNearerThan(double other, double confidence, double unsure) const {
    const Interval surely = interval(confidence);
    const double towards = other > value ? surely.high - value : value - surely.low;
    return 0.5 * std::abs(value - other) > towards + unsure;
}

Estimate estimateWithin(double value, const Interval& interval_95, double degrees_of_freedom) {
    const double half = 0.5 * (interval_95.high - interval_95.low);
    const double middle = 0.5 * (interval_95.high + interval_95.low);
    const double per_error = Estimate{0.0, 1.0, degrees_of_freedom}.margin();
    return {value, half / per_error, degrees_of_freedom,
            half > 0.0 ? (middle - value) / half : 0.0};
}

}  // namespace hedr
