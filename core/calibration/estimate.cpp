#include "core/calibration/estimate.h"

#include <cmath>

#include "core/calibration/distributions.h"

namespace hedr {

double Estimate::margin(double confidence) const {
    return studentQuantile(0.5 + 0.5 * confidence, degrees_of_freedom) * standard_error;
}

Interval Estimate::interval(double confidence) const {
    const double half = margin(confidence);
    return {value - half, value + half};
}

bool Estimate::isNearerThan(double other, double confidence, double unsure) const {
    return 0.5 * std::abs(value - other) > margin(confidence) + unsure;
}

}  // namespace hedr
