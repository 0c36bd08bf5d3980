#pragma once

namespace hedr {

// Quantiles and tails of the distributions that calibration judges by, from Boost.Math.
// Probabilities are in (0, 1), degrees of freedom above 0; they need not be whole, and
// for Student's t may be infinite.
double normalQuantile(double probability);
double studentQuantile(double probability, double degrees_of_freedom);
double chiSquaredQuantile(double probability, double degrees_of_freedom);

// The probability of a value above that, which may be infinite; of NaN it is 1.
double chiSquaredTail(double value, double degrees_of_freedom);

}  // namespace hedr
