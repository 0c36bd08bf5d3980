#include "core/simulation/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedr {
namespace {

TEST(Random, GivesTheSameNumbersOnEveryMachine) {
    Random random(42);
    EXPECT_EQ(random.uniform(), 0.75515553295453897);
    EXPECT_EQ(random.normal(), -0.27112856856547296);
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
    Random random(7);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kCount = 100000;
    for (int i = 0; i < kCount; ++i) {
        const double x = random.normal();
        sum += x;
        squares += x * x;
    }
    EXPECT_NEAR(sum / kCount, 0.0, 0.01);
    EXPECT_NEAR(squares / kCount, 1.0, 0.015);
}

TEST(CorrelatedNoise, ForgetsAnEthOfItselfWithinItsTime) {
    Random random(3);
    CorrelatedNoise noise(2.0, 0.1);
    std::vector<double> values;
    for (int i = 0; i < 200000; ++i) values.push_back(noise.next(random));
    double squares = 0.0;
    double products = 0.0;
    for (std::size_t i = 0; i + 20 < values.size(); ++i) {
        squares += values[i] * values[i];
        products += values[i] * values[i + 20];
    }
    const double count = static_cast<double>(values.size() - 20);
    EXPECT_NEAR(squares / count, 1.0, 0.05);
    EXPECT_NEAR(products / squares, std::exp(-1.0), 0.03);
}

}  // namespace
}  // namespace hedr
