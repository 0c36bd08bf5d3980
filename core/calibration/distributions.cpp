#include "core/calibration/distributions.h"

#include <gsl/gsl_cdf.h>

#include <cassert>
#include <cmath>

namespace hedr {

namespace {

bool isProbability(double p) { return p > 0.0 && p < 1.0; }

}  // namespace

double normalQuantile(double probability) {
    assert(isProbability(probability));
    return gsl_cdf_ugaussian_Pinv(probability);
}

double studentQuantile(double probability, double degrees_of_freedom) {
    assert(isProbability(probability) && degrees_of_freedom > 0.0);
    constexpr double kAsGoodAsNormal = 1e7;
    if (degrees_of_freedom > kAsGoodAsNormal) return normalQuantile(probability);
    return gsl_cdf_tdist_Pinv(probability, degrees_of_freedom);
}

double chiSquaredQuantile(double probability, double degrees_of_freedom) {
    assert(isProbability(probability) && degrees_of_freedom > 0.0);
    return gsl_cdf_chisq_Pinv(probability, degrees_of_freedom);
}

double normalTail(double value) { return gsl_cdf_ugaussian_Q(value); }

double chiSquaredTail(double value, double degrees_of_freedom) {
    assert(degrees_of_freedom > 0.0);
    return value <= 0.0 ? 1.0 : gsl_cdf_chisq_Q(value, degrees_of_freedom);
}

}  // namespace hedr
