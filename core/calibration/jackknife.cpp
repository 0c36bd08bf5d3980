#include "core/calibration/jackknife.h"

#include <cmath>

namespace hedr {

Estimate jackknifed(double value, std::span<const double> without) {
    const auto count = static_cast<double>(without.size());
    double mean = 0.0;
    for (const double each : without) mean += each / count;
    double squares = 0.0;
    for (const double each : without) squares += (each - mean) * (each - mean);
    return {value, std::sqrt((count - 1.0) / count * squares), count - 1.0};
}

}  // namespace hedr
