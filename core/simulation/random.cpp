#include "core/simulation/random.h"

#include <cmath>

namespace hedr {

CorrelatedNoise::CorrelatedNoise(double correlation_s, double step_s)
    : keep_(std::exp(-step_s / correlation_s)), stir_(std::sqrt(1.0 - keep_ * keep_)) {}

double CorrelatedNoise::next(Random& random) {
    value_ = keep_ * value_ + stir_ * random.normal();
    return value_;
}

}  // namespace hedr
