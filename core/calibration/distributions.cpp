#include "core/calibration/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>

namespace hedr {

namespace {

bool isProbability(double p) { return p > 0.0 && p < 1.0; }

// What is too large for a number is infinite, and stops no program.
using Quietly = boost::math::policies::policy<
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;
using StudentsT = boost::math::students_t_distribution<double, Quietly>;
using ChiSquared = boost::math::chi_squared_distribution<double, Quietly>;

}  // namespace

double normalQuantile(double probability) {
    assert(isProbability(probability));
    return quantile(boost::math::normal(), probability);
}

double studentQuantile(double probability, double degrees_of_freedom) {
    assert(isProbability(probability) && degrees_of_freedom > 0.0);
    constexpr double kAsGoodAsNormal = 1e7;
    if (degrees_of_freedom > kAsGoodAsNormal) return normalQuantile(probability);
    return quantile(StudentsT(degrees_of_freedom), probability);
}

double chiSquaredQuantile(double probability, double degrees_of_freedom) {
    assert(isProbability(probability) && degrees_of_freedom > 0.0);
    return quantile(ChiSquared(degrees_of_freedom), probability);
}

double chiSquaredTail(double value, double degrees_of_freedom) {
    assert(degrees_of_freedom > 0.0);
    if (!(value > 0.0)) return 1.0;
    if (std::isinf(value)) return 0.0;
    return cdf(complement(ChiSquared(degrees_of_freedom), value));
}

}  // namespace hedr
