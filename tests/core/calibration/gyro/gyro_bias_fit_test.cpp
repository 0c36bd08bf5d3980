#include "core/calibration/gyro/gyro_bias_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

constexpr double kPeriod_s = 0.02;

struct FitTrial {
    std::string name;
    double duration_s = 60.0;
    double noise_deg_s_sqrthz = 0.03;
    double ramp_deg_s2 = 0.0;
    double correlated_deg_s = 0.0;  // deviation of noise that lasts for 0.3 s
    double outlier_share = 0.0;     // 10 °/s, all to the same side
};

std::ostream& operator<<(std::ostream& stream, const FitTrial& trial) {
    return stream << trial.name;
}

// The true mean is 1 °/s.
std::vector<GyroSample> standingSamples(const FitTrial& trial, Random& random) {
    CorrelatedNoise correlated(0.3, kPeriod_s);
    const double deviation_deg_s = trial.noise_deg_s_sqrthz / std::sqrt(kPeriod_s);
    std::vector<GyroSample> samples;
    for (double t_s = kPeriod_s; t_s < trial.duration_s; t_s += kPeriod_s) {
        double rate_deg_s = 1.0 + trial.ramp_deg_s2 * (t_s - 0.5 * trial.duration_s) +
                            deviation_deg_s * random.normal() +
                            trial.correlated_deg_s * correlated.next(random);
        if (random.uniform() < trial.outlier_share) rate_deg_s += 10.0;
        samples.push_back({t_s, kPeriod_s, radFromDeg(rate_deg_s)});
    }
    return samples;
}

class GyroBiasFitTrials : public testing::TestWithParam<FitTrial> {};

// 95 % of 1,500 are 93.9 to 96.1 % by chance (two standard deviations).
TEST_P(GyroBiasFitTrials, AreUnbiasedAndTheirIntervalsCoverTheTruth) {
    constexpr int kRuns = 1500;
    const double truth_rad_s = radFromDeg(1.0);
    int covered = 0;
    double sum = 0.0;
    double squares = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        Random random(static_cast<std::uint64_t>(run) + 100);
        const Estimate mean =
            fitGyroBias(standingSamples(GetParam(), random), kPeriod_s).mean_rad_s;
        covered += mean.interval().contains(truth_rad_s) ? 1 : 0;
        const double error_rad_s = mean.value - truth_rad_s;
        sum += error_rad_s / kRuns;
        squares += error_rad_s * error_rad_s / kRuns;
    }
    EXPECT_GE(covered, 0.93 * kRuns);
    EXPECT_LE(covered, 0.97 * kRuns);
    EXPECT_LT(std::abs(sum), 0.2 * std::sqrt(squares));
    RecordProperty("covered", covered);
}

INSTANTIATE_TEST_SUITE_P(Standing, GyroBiasFitTrials,
                         testing::Values(FitTrial{"plain", 30.0}, FitTrial{"few", 10.0},
                                         FitTrial{"temperature ramp", 30.0, 0.01, 0.0005},
                                         FitTrial{"correlated noise", 30.0, 0.02, 0.0, 0.03},
                                         FitTrial{"outliers", 30.0, 0.02, 0.0, 0.0, 0.005}));

TEST(GyroBiasFit, TellsDriftAndNoise) {
    Random random(1);
    const GyroBiasFit fit =
        fitGyroBias(standingSamples({"", 120.0, 0.02, 0.0005}, random), kPeriod_s);
    EXPECT_TRUE(fit.drift_rad_s2.interval(0.999).contains(radFromDeg(0.0005)));
    EXPECT_FALSE(fit.drift_rad_s2.interval().contains(0.0));
    EXPECT_TRUE(fit.noise_rad_s_sqrthz.interval(0.999).contains(radFromDeg(0.02)));
    EXPECT_EQ(fit.outliers, 0u);
}

TEST(GyroBiasFit, SaysThatACoarseGyroIsNotKnownBetterThanItsStep) {
    std::vector<GyroSample> samples;
    for (int i = 0; i < 2000; ++i) {
        const bool flipped = i % 50 == 0;  // a bias of 0.4 steps, hardly any noise
        samples.push_back({kPeriod_s * i, kPeriod_s, radFromDeg(flipped ? 0.5 : 0.0)});
    }
    const GyroBiasFit fit = fitGyroBias(samples, kPeriod_s);
    EXPECT_TRUE(fit.mean_rad_s.interval().contains(radFromDeg(0.2)));
}

TEST(GyroBiasFit, WaitsLongerTheNoisierTheGyroWithinSensibleLimits) {
    Random random(2);
    const double wanted_rad_s = radFromDeg(0.005);
    const auto needed = [&](double noise_deg, double duration_s) {
        const auto samples = standingSamples({"", duration_s, noise_deg}, random);
        return standingNeeded_s(samples, radFromDeg(noise_deg), wanted_rad_s);
    };
    EXPECT_DOUBLE_EQ(needed(0.005, 30.0), 20.0);
    EXPECT_NEAR(needed(0.03, 30.0), 36.0, 1e-9);
    EXPECT_DOUBLE_EQ(needed(0.5, 30.0), 300.0);
}

TEST(GyroBiasFit, DoesNotWaitForWhatAWanderingBiasCannotGive) {
    Random random(3);
    std::vector<GyroSample> samples = standingSamples({"", 240.0, 0.04}, random);
    double bias_rad_s = 0.0;
    for (GyroSample& sample : samples) {
        bias_rad_s += radFromDeg(0.02) * std::sqrt(kPeriod_s) * random.normal();
        sample.rate_rad_s += bias_rad_s;
    }
    EXPECT_LT(standingNeeded_s(samples, radFromDeg(0.04), radFromDeg(0.005)), 45.0);
}

}  // namespace
}  // namespace hedr
