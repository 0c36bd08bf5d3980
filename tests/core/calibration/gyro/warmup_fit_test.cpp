#include "core/calibration/gyro/warmup_fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "core/calibration/whiteness.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/gyro/warmup_blocks.h"

namespace hedr {
namespace {

// C1, C2, T.
using Three = std::array<double, 3>;

Three estimatesOf(const GyroDrift& curve) { return {curve.c1_rad_s, curve.c2_rad_s, curve.time_s}; }

// What many fits of records of one kind are like.
struct Many {
    int runs = 0;
    Three mean{};       // of the errors
    Three deviation{};  // of the estimates
    Three covered{};    // share of 95 % intervals
    Three within_10{};  // share within ten per cent
    double white = 0.0;
    int most_iterations = 0;
};

Many fitMany(const BlockRecord& record, int runs, std::uint64_t seed) {
    Random random(seed);
    Many many{.runs = runs};
    const Three truth = estimatesOf(record.curve);
    Three squares{};
    const double each = 1.0 / runs;
    for (int run = 0; run < runs; ++run) {
        const WarmupFit fit = fitWarmup(blocksOf(record, random), record.room);
        const std::array estimates{fit.c1_rad_s(), fit.c2_rad_s(), fit.time_s()};
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double error = estimates[i].value - truth[i];
            many.mean[i] += each * error;
            squares[i] += each * error * error;
            many.covered[i] += estimates[i].interval().contains(truth[i]) ? each : 0.0;
            many.within_10[i] += std::abs(error) < 0.1 * std::abs(truth[i]) ? each : 0.0;
        }
        const bool white = whitenessOf(fit.residuals_rad_s).isWhite();
        many.white += white && fit.slow_misfit_p > 0.005 ? each : 0.0;
        many.most_iterations = std::max(many.most_iterations, fit.iterations);
    }
    for (std::size_t i = 0; i < truth.size(); ++i)
        many.deviation[i] = std::sqrt(squares[i] - many.mean[i] * many.mean[i]);
    return many;
}

// The least variances that any unbiased estimates can have (Cramér, Rao).
Eigen::VectorXd leastVariances(const BlockRecord& record) {
    Random random(1);
    const std::vector<WarmupBlock> blocks = blocksOf(record, random);
    const Eigen::MatrixXd jacobian = warmupJacobian(blocks, record.curve, record.room);
    const double variance =
        record.noise_rad_s_sqrthz * record.noise_rad_s_sqrthz / blocks.front().span_s();
    const Eigen::MatrixXd information = jacobian.transpose() * jacobian / variance;
    return information.inverse().diagonal();
}

Three leastDeviations(const BlockRecord& record) {
    const Eigen::VectorXd variances = leastVariances(record);
    return {std::sqrt(variances[0]), std::sqrt(variances[1]),
            std::sqrt(variances[2]) * record.curve.time_s};
}

void print(const BlockRecord& record, const Many& many) {
    constexpr std::array kNames{"C1", "C2", "T"};
    const Three truth = estimatesOf(record.curve);
    const Three least = leastDeviations(record);
    std::cout << record.minutes << " min, flicker " << degFromRad(record.flicker_rad_s)
              << " deg/s, " << many.runs << " runs: white " << 100.0 * many.white << " %, at most "
              << many.most_iterations << " iterations\n";
    if (record.room == RoomTemperature::kMayChange) {
        std::cout << "  room: least sigma in 20 min "
                  << degFromRad(1200.0 * std::sqrt(leastVariances(record)[3])) << " deg/s\n";
    }
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double per_cent = 100.0 / std::abs(truth[i]);
        std::cout << "  " << kNames[i] << ": sigma " << per_cent * many.deviation[i] << " % (least "
                  << per_cent * least[i] << " %), mean error " << many.mean[i] / many.deviation[i]
                  << " sigma, 95 % covers " << 100.0 * many.covered[i]
                  << " %, within 10 %: " << 100.0 * many.within_10[i] << " %\n";
    }
}

void expectHonest(const Many& many) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(std::abs(many.mean[i]), 0.2 * many.deviation[i]);
        EXPECT_GE(many.covered[i], 0.93);
        EXPECT_LE(many.covered[i], 0.97);
    }
}

// Two hundred records; the bounds leave room for chance.
void expectHonestAndEfficient(const BlockRecord& record, const Many& many) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(std::abs(many.mean[i]), 0.2 * many.deviation[i]);
        EXPECT_GE(many.covered[i], 0.92);
        EXPECT_LT(many.deviation[i], 1.2 * leastDeviations(record)[i]);
    }
}

TEST(WarmupFit, FindsACurveWithoutNoise) {
    for (const GyroDrift& curve : {kGyrostar, GyroDrift{-0.002, 0.02, 90.0}}) {
        Random random(1);
        const BlockRecord record{.curve = curve, .noise_rad_s_sqrthz = 1e-9};
        const WarmupFit fit = fitWarmup(blocksOf(record, random));
        EXPECT_TRUE(fit.converged);
        EXPECT_NEAR(fit.curve.c1_rad_s / curve.c1_rad_s, 1.0, 1e-5);
        EXPECT_NEAR(fit.curve.c2_rad_s / curve.c2_rad_s, 1.0, 1e-5);
        EXPECT_NEAR(fit.curve.time_s / curve.time_s, 1.0, 1e-5);
    }
}

// Means without any noise leave nothing, or next to nothing, that could be compared.
TEST(WarmupFit, TakesMeansOfNothing) {
    for (const double mean_rad_s : {0.0, 1e-300, 1e200, 1e308}) {
        std::vector<WarmupBlock> blocks;
        for (int i = 0; i < 40; ++i) blocks.push_back({10.0 * i, 10.0 * (i + 1), mean_rad_s, 10.0});
        for (const RoomTemperature room : {RoomTemperature::kSteady, RoomTemperature::kMayChange})
            EXPECT_EQ(fitWarmup(blocks, room).residuals_rad_s.size(), blocks.size());
    }
}

TEST(WarmupFit, TakesBlocksThatWereMissed) {
    Random random(2);
    std::vector<WarmupBlock> blocks = blocksOf({.noise_rad_s_sqrthz = 1e-9}, random);
    blocks.erase(blocks.begin() + 10, blocks.begin() + 30);
    blocks.erase(blocks.begin());
    const WarmupFit fit = fitWarmup(blocks);
    EXPECT_NEAR(fit.curve.time_s, kGyrostar.time_s, 0.01);
}

TEST(WarmupFit, KnowsItsDerivatives) {
    Random random(3);
    const std::vector<WarmupBlock> blocks = blocksOf({}, random);
    const Eigen::MatrixXd jacobian = warmupJacobian(blocks, kGyrostar);
    constexpr double kStep = 1e-5;
    GyroDrift longer = kGyrostar;
    GyroDrift shorter = kGyrostar;
    longer.time_s *= std::exp(kStep);
    shorter.time_s *= std::exp(-kStep);
    for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
        const WarmupBlock& block = blocks[static_cast<std::size_t>(i)];
        const double slope = (meanBias(block, longer) - meanBias(block, shorter)) / (2.0 * kStep);
        EXPECT_NEAR(jacobian(i, 2), slope, 1e-10);
    }
}

// Must-show: the Gyrostar's figures within ten per cent after twenty minutes. C1 and C2 are; T is
// in as many records as the noise lets it be: its least standard deviation is 7 %, so that 84 %
// are within ten at best.
TEST(WarmupFit, HasTheGyrostarsFiguresAfterTwentyMinutes) {
    const BlockRecord record{};
    const Many many = fitMany(record, 200, 4);
    print(record, many);
    EXPECT_LE(many.most_iterations, 10);
    EXPECT_GE(many.white, 0.95);
    EXPECT_GE(many.within_10[0], 0.999);
    EXPECT_GE(many.within_10[1], 0.999);
    EXPECT_GE(many.within_10[2], 0.75);
    expectHonestAndEfficient(record, many);
}

// A longer T bends less: of short records it may be further above than below, and is missed there
// no more often than on the other side.
TEST(WarmupFit, KnowsThatTheTimeMayBeMuchLonger) {
    constexpr int kRuns = 400;
    int above = 0;
    int below = 0;
    for (const RoomTemperature room : {RoomTemperature::kSteady, RoomTemperature::kMayChange}) {
        Random random(15);
        const double minutes = room == RoomTemperature::kSteady ? 12.0 : 28.0;
        for (int run = 0; run < kRuns; ++run) {
            const WarmupFit fit = fitWarmup(blocksOf({.minutes = minutes}, random), room);
            EXPECT_GT(fit.time_s().lopsided, 0.0);
            above += fit.time_95_s.high < kGyrostar.time_s ? 1 : 0;
            below += fit.time_95_s.low > kGyrostar.time_s ? 1 : 0;
        }
    }
    std::cout << "T above the interval in " << above << ", below it in " << below << " of "
              << 2 * kRuns << '\n';
    for (const int missed : {above, below}) {
        EXPECT_GE(missed, 0.01 * 2 * kRuns);
        EXPECT_LE(missed, 0.04 * 2 * kRuns);
    }
}

// A gyro that was on for long before: what it was when cold is far from what was seen.
TEST(WarmupFit, HoldsFarFromWhereItWasSwitchedOn) {
    constexpr int kRuns = 400;
    const GyroDrift truth{radFromDeg(2.0), radFromDeg(-0.6), 120.0};
    Random random(16);
    std::array<int, 3> held{};
    for (int run = 0; run < kRuns; ++run) {
        std::vector<WarmupBlock> blocks;
        for (int i = 0; i < 100; ++i) {
            WarmupBlock block{480.0 + 15.0 * i, 495.0 + 15.0 * i, 0.0, 15.0};
            block.mean_rad_s = meanBias(block, truth) + 2e-5 * random.normal();
            blocks.push_back(block);
        }
        const WarmupFit fit = fitWarmup(blocks);
        EXPECT_TRUE(fit.converged);
        EXPECT_LE(fit.iterations, 10);
        const std::array estimates{fit.c1_rad_s(), fit.c2_rad_s(), fit.time_s()};
        const std::array truths = estimatesOf(truth);
        for (std::size_t i = 0; i < held.size(); ++i)
            held[i] += estimates[i].interval().contains(truths[i]) ? 1 : 0;
        const WarmupFit again = refitWarmup(blocks, fit);
        EXPECT_NEAR(again.curve.c1_rad_s / fit.curve.c1_rad_s, 1.0, 1e-3);
    }
    for (const int each : held) EXPECT_GE(each, 0.92 * kRuns);
}

// Whatever a room does steadily, the fit that expects it finds the same curve.
TEST(WarmupFit, IsNotMovedByARoomThatMayChange) {
    std::vector<GyroDrift> curves;
    for (const double room_rad_s : {0.0, radFromDeg(0.1)}) {
        Random random(5);
        const BlockRecord record{.minutes = 40.0,
                                 .besides = [=](double t_s) { return room_rad_s * t_s / 1200.0; }};
        const WarmupFit fit = fitWarmup(blocksOf(record, random), RoomTemperature::kMayChange);
        EXPECT_TRUE(fit.room_rad_s2().interval(0.999).contains(room_rad_s / 1200.0));
        curves.push_back(fit.curve);
    }
    EXPECT_NEAR(curves[0].c1_rad_s / curves[1].c1_rad_s, 1.0, 1e-3);
    EXPECT_NEAR(curves[0].time_s / curves[1].time_s, 1.0, 1e-3);
}

TEST(WarmupFit, CoversAsItSaysInARoomThatChanges) {
    const BlockRecord record{.minutes = 35.0,
                             .room = RoomTemperature::kMayChange,
                             .besides = [](double t_s) { return radFromDeg(1e-5) * t_s; }};
    const Many many = fitMany(record, 200, 4);
    print(record, many);
    EXPECT_LE(many.most_iterations, 10);
    expectHonestAndEfficient(record, many);
}

// How many of a hundred records do not look like the curve.
int departuresIn(const BlockRecord& record, std::uint64_t seed) {
    return static_cast<int>(std::lround(100.0 * (1.0 - fitMany(record, 100, seed).white)));
}

TEST(WarmupFit, LeavesWhatIsNotNoiseWhereTheDataAreNoSuchCurve) {
    const auto step = [](double t_s) { return t_s > 660.0 ? radFromDeg(0.04) : 0.0; };
    const auto aside = [](double t_s) { return std::abs(t_s - 500.0) < 60.0 ? 8e-4 : 0.0; };
    const auto swing = [](double t_s) { return radFromDeg(0.02) * std::sin(t_s / 15.0); };
    const auto second = [](double t_s) { return -radFromDeg(0.15) * std::expm1(-t_s / 50.0); };
    const auto ramp = [](double t_s) { return radFromDeg(0.1) * t_s / 3600.0; };
    EXPECT_LE(departuresIn({}, 1), 5);
    EXPECT_GE(departuresIn({.besides = step}, 2), 95);
    EXPECT_GE(departuresIn({.besides = aside}, 3), 95);
    EXPECT_GE(departuresIn({.besides = swing}, 4), 95);
    EXPECT_GE(departuresIn({.besides = second}, 5), 95);
    EXPECT_GE(departuresIn({.minutes = 60.0, .besides = ramp}, 6), 95);
}

TEST(WarmupFit, DISABLED_CoversAsItSays) {
    for (const double minutes : {10.0, 15.0, 20.0, 25.0, 30.0, 40.0}) {
        const BlockRecord record{.minutes = minutes};
        const Many many = fitMany(record, 4000, 7);
        print(record, many);
        EXPECT_LE(many.most_iterations, 10);
        expectHonest(many);
    }
    for (const double flicker_deg_s : {0.001, 0.002, 0.004, 0.008}) {
        const BlockRecord record{.flicker_rad_s = radFromDeg(flicker_deg_s)};
        print(record, fitMany(record, 1000, 8));
    }
}

// Must-show: with a ramp of temperature too. A room that was told to be steady and is not moves the
// curve instead; the table ends with that.
TEST(WarmupFit, DISABLED_CoversAsItSaysInARoomThatMayChange) {
    const auto room = [](double drift_deg_s) {
        std::cout << "drift of " << drift_deg_s << " deg/s in 20 min: ";
        return [=](double t_s) { return radFromDeg(drift_deg_s) * t_s / 1200.0; };
    };
    for (const double minutes : {20.0, 25.0, 30.0, 35.0, 40.0, 60.0}) {
        const BlockRecord record{
            .minutes = minutes, .room = RoomTemperature::kMayChange, .besides = room(0.01)};
        const Many many = fitMany(record, 4000, 10);
        print(record, many);
        if (minutes > 20.0) expectHonest(many);
    }
    for (const double drift_deg_s : {-0.03, 0.1}) {
        const BlockRecord record{
            .minutes = 35.0, .room = RoomTemperature::kMayChange, .besides = room(drift_deg_s)};
        print(record, fitMany(record, 1000, 10));
    }
    const BlockRecord untold{.besides = room(0.01)};
    print(untold, fitMany(untold, 1000, 9));
}

}  // namespace
}  // namespace hedr
