#pragma once

#include <span>

#include "core/calibration/estimate.h"

namespace hedr {

// The value that all parts give, with the standard error (delete-one jackknife) of what each gives
// when it is left out. At least two parts.
Estimate jackknifed(double value, std::span<const double> without);

}  // namespace hedr
