#include "core/calibration/whiteness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/simulation/random.h"

namespace hedr {
namespace {

// Each value keeps that share of the one before it.
std::vector<double> noiseThatKeeps(double share, std::size_t count, Random& random) {
    std::vector<double> values;
    double value = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        value = share * value + random.normal();
        values.push_back(value);
    }
    return values;
}

TEST(Whiteness, HasTheAutocorrelationOfAKnownSeries) {
    const std::vector<double> to_and_fro{1, -1, 1, -1, 1, -1, 1, -1, 1, -1};
    const Whiteness whiteness = whitenessOf(to_and_fro);
    ASSERT_EQ(whiteness.autocorrelation.size(), 2U);
    EXPECT_DOUBLE_EQ(whiteness.autocorrelation[0], -0.9);
    EXPECT_DOUBLE_EQ(whiteness.autocorrelation[1], 0.8);
    EXPECT_NEAR(whiteness.band, 1.96 / std::sqrt(10.0), 1e-4);
    // Ljung and Box: n (n + 2) (r1² / (n - 1) + r2² / (n - 2))
    EXPECT_NEAR(whiteness.statistic, 10.0 * 12.0 * (0.81 / 9.0 + 0.64 / 8.0), 1e-12);
    EXPECT_NEAR(whiteness.p_value, std::exp(-0.5 * whiteness.statistic), 1e-12);  // 2 degrees
}

TEST(Whiteness, IsSeenInWhiteNoise) {
    Random random(1);
    constexpr int kRuns = 4000;
    int beyond_5 = 0;
    int refused = 0;
    for (int run = 0; run < kRuns; ++run) {
        const Whiteness whiteness = whitenessOf(noiseThatKeeps(0.0, 100, random));
        beyond_5 += whiteness.p_value < 0.05 ? 1 : 0;
        refused += whiteness.isWhite() ? 0 : 1;
    }
    EXPECT_NEAR(beyond_5, 0.05 * kRuns, 0.025 * kRuns);
    EXPECT_LE(refused, 0.025 * kRuns);
}

TEST(Whiteness, IsNotSeenInNoiseThatKeepsHalfOfItself) {
    Random random(2);
    constexpr int kRuns = 500;
    int refused = 0;
    for (int run = 0; run < kRuns; ++run)
        refused += whitenessOf(noiseThatKeeps(0.5, 100, random)).isWhite() ? 0 : 1;
    EXPECT_GE(refused, 0.95 * kRuns);
}

TEST(Whiteness, HasNothingAgainstTooFewValuesOrNone) {
    EXPECT_TRUE(whitenessOf({}).isWhite());
    EXPECT_TRUE(whitenessOf(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}).isWhite());
    EXPECT_TRUE(whitenessOf(std::vector<double>(100, 0.0)).isWhite());
    EXPECT_TRUE(whitenessOf(std::vector<double>(100, std::nan(""))).isWhite());
}

TEST(Whiteness, IsDrawnWithItsBand) {
    Random random(3);
    const Whiteness whiteness = whitenessOf(noiseThatKeeps(0.0, 100, random));
    const EvidencePlot plot = autocorrelationPlot(whiteness, 12.0);
    ASSERT_EQ(plot.series.size(), 2U);
    EXPECT_EQ(plot.series[0].y_high.back(), whiteness.band);
    EXPECT_EQ(plot.series[1].y, whiteness.autocorrelation);
    EXPECT_DOUBLE_EQ(plot.series[1].x.front(), 12.0);
    EXPECT_TRUE(autocorrelationPlot({}, 12.0).series[1].x.empty());
}

}  // namespace
}  // namespace hedr
