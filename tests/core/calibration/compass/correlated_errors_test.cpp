#include "core/calibration/compass/correlated_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/simulation/random.h"

namespace hedr {
namespace {

constexpr Eigen::Index kCount = 600;
const std::vector<std::size_t> kTwoStretches{0, 300};

Eigen::VectorXd noiseOf(Random& random, double correlation_s) {
    CorrelatedNoise noise(correlation_s, 1.0);
    Eigen::VectorXd values(kCount);
    for (double& value : values) value = correlation_s > 0.0 ? noise.next(random) : random.normal();
    return values;
}

// Of the mean of noise that forgets itself within ten readings: with the sum over lags, and with
// what the mean took of it.
TEST(CorrelatedErrors, TellTheErrorOfAMean) {
    Random random(1);
    const Eigen::MatrixXd design = Eigen::MatrixXd::Ones(kCount, 1);
    constexpr int kRuns = 300;
    double stated = 0.0;
    double actual = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        const auto fit = fitWithCorrelatedErrors(design, noiseOf(random, 10.0), kTwoStretches);
        stated += fit.covariance(0, 0) / kRuns;
        actual += fit.coefficients(0) * fit.coefficients(0) / kRuns;
    }
    EXPECT_NEAR(std::sqrt(stated / actual), 1.0, 0.12);
}

TEST(CorrelatedErrors, ArePlainOnesOfWhiteNoise) {
    Random random(2);
    const Eigen::MatrixXd design = Eigen::MatrixXd::Ones(kCount, 1);
    int rare = 0;
    for (int run = 0; run < 200; ++run) {
        const auto fit = fitWithCorrelatedErrors(design, noiseOf(random, 0.0), kTwoStretches);
        EXPECT_NEAR(fit.covariance(0, 0) * kCount, 1.0, 0.6);
        rare += fit.chanceOf(0, 1) < 0.05 ? 1 : 0;
    }
    EXPECT_GE(rare, 2);
    EXPECT_LE(rare, 22);
}

}  // namespace
}  // namespace hedr
