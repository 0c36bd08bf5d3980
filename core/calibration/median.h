#pragma once

#include <vector>

namespace hedr {

// The middle one of some values, at least one; of an even number of them the upper of the two.
double medianOf(std::vector<double> values);

}  // namespace hedr
