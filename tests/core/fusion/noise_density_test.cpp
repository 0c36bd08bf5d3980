#include "core/fusion/noise_density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/random.h"

namespace hedr {
namespace {

constexpr double kDensity = 0.04;
constexpr double kStep_s = 0.5;

// White noise on a rate that has a bias and drifts.
void feed(NoiseDensity& noise, int steps, std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < steps; ++i) {
        const double rate = 3.0 + 0.01 * i * kStep_s;
        noise.add(rate * kStep_s + std::sqrt(kDensity * kStep_s) * random.normal(), kStep_s);
    }
}

TEST(NoiseDensity, IsFoundUnderABiasAndADrift) {
    NoiseDensity noise({.block_span = 2.0, .prior = 1.0, .prior_weight = 1.0, .most_weight = 1e6});
    feed(noise, 40000, 1);
    EXPECT_NEAR(noise.density(), kDensity, 0.1 * kDensity);
}

TEST(NoiseDensity, IsThePriorAtFirst) {
    NoiseDensity noise({.block_span = 2.0, .prior = 0.5});
    feed(noise, 8, 2);
    EXPECT_EQ(noise.density(), 0.5);
}

TEST(NoiseDensity, ComparesNothingAcrossAnInterruption) {
    NoiseDensity noise({.block_span = 1.0, .prior = 0.5});
    for (const double rate : {0.0, 0.0, 1000.0, 1000.0}) {
        if (rate > 0.0) noise.interrupt();
        noise.add(rate, 1.0);
    }
    EXPECT_EQ(noise.density(), 0.5);
}

TEST(NoiseDensity, FollowsWhatHasChanged) {
    NoiseDensity noise(
        {.block_span = 2.0, .prior = 100.0, .prior_weight = 4.0, .most_weight = 60.0});
    feed(noise, 8000, 3);
    EXPECT_NEAR(noise.density(), kDensity, 0.75 * kDensity);
}

}  // namespace
}  // namespace hedr
