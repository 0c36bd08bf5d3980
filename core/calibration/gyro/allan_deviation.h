#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"

namespace hedr {

// The overlapping Allan deviation at one averaging time, in the unit of the rates.
struct AllanPoint {
    std::size_t factor = 1;  // averaging time over sampling period
    double tau_s = 0.0;
    double deviation = 0.0;
    std::size_t terms = 0;
    int noise_exponent =
        0;  // the spectrum goes with f to it: 2 white angle ... -2 walk of the rate
    double degrees_of_freedom = 0.0;
    Interval band{};  // 95 %
};

// 1, 2, 4, ... as long as two averages fit into so many rates.
std::vector<std::size_t> octaveFactors(std::size_t rates);

// Of rates at even distances, a mean each over the period. W. J. Riley, "Handbook of Frequency
// Stability Analysis", NIST SP 1065, 2008: Eq. (11) for the deviation, Table 5 for the degrees of
// freedom, section 5.5.3 for which noise it is. Factors must be at least 1 and at most half of the
// number of rates.
std::vector<AllanPoint> allanDeviation(std::span<const double> rates, double period_s,
                                       std::span<const std::size_t> factors);

}  // namespace hedr
