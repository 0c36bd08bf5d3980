#pragma once

#include <cstdint>
#include <random>

namespace hedr {

// Random numbers that are the same for a seed with every compiler and library: the engine is fixed
// by the C++ standard, but its distributions are not.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    // In [0, 1), all 53 bits random.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    // Mean 0, variance 1. The sum of twelve uniform numbers needs no logarithm, whose last bit
    // differs between processors; its tails end at 6 sigma.
    double normal() {
        double sum = -6.0;
        for (int pair = 0; pair < 6; ++pair) {
            const std::uint64_t bits = engine_();
            sum += static_cast<double>(bits >> 32) * 0x1p-32;
            sum += static_cast<double>(bits & 0xffffffffU) * 0x1p-32;
        }
        return sum;
    }

  private:
    std::mt19937_64 engine_;
};

// A random value that forgets itself within `correlation_s` and has mean 0 and variance 1
// (Ornstein-Uhlenbeck process).
class CorrelatedNoise {
  public:
    CorrelatedNoise(double correlation_s, double step_s);
    double next(Random& random);

  private:
    double keep_;
    double stir_;
    double value_ = 0.0;
};

}  // namespace hedr
