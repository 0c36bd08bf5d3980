#include "core/calibration/compass/ellipse_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

const MagnetometerRange kAskew{3.0, -20.0, 40.0, 25.0, -0.4};

std::vector<Eigen::Vector2d> readingsOf(const MagnetometerRange& range, double noise,
                                        std::uint64_t seed, int count = 400, double turns = 2.0) {
    Random random(seed);
    const Ellipse ellipse = ellipseFrom(range);
    std::vector<Eigen::Vector2d> field;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector2d off(random.normal(), random.normal());
        field.emplace_back(ellipse.at(2.0 * kPi * turns * i / count) + noise * off);
    }
    return field;
}

void expectSame(const MagnetometerRange& found, const MagnetometerRange& truth, double by) {
    EXPECT_NEAR(found.centre_x, truth.centre_x, by);
    EXPECT_NEAR(found.centre_y, truth.centre_y, by);
    EXPECT_NEAR(found.range_x, truth.range_x, by);
    EXPECT_NEAR(found.range_y, truth.range_y, by);
    EXPECT_NEAR(found.correlation, truth.correlation, by);
}

TEST(EllipseFit, IsExactWithoutNoise) {
    for (const MagnetometerRange& truth :
         {kAskew, MagnetometerRange{}, MagnetometerRange{1e3, 1e3, 1.0, 2.0, 0.9}}) {
        const auto fit = fitEllipse({readingsOf(truth, 0.0, 1), {0}});
        ASSERT_TRUE(fit);
        expectSame(rangeOf(fit->ellipse), truth, 1e-6);
    }
}

TEST(EllipseFit, IsExactFromAThirdOfATurn) {
    const auto fit = fitEllipse({readingsOf(kAskew, 0.0, 1, 400, 0.35), {0}});
    ASSERT_TRUE(fit);
    expectSame(rangeOf(fit->ellipse), kAskew, 1e-5);
}

TEST(EllipseFit, IsOneToOneWithTheRange) {
    expectSame(rangeOf(ellipseFrom(kAskew)), kAskew, 1e-12);
}

// Without the noise along the ellipse taken off, ranges would be larger by noise² / (2 radius),
// 0.08 here. The algebraic start is no better.
TEST(EllipseFit, HasNoBiasInMuchNoise) {
    constexpr int kRuns = 200;
    constexpr double kNoise = 2.0;
    double by_fit = 0.0;
    double by_start = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        const auto field =
            readingsOf({0.0, 0.0, 30.0, 20.0, 0.0}, kNoise, static_cast<std::uint64_t>(run) + 1);
        const auto fit = fitEllipse({field, {0}});
        const auto start = directEllipse(field);
        ASSERT_TRUE(fit && start);
        by_fit += (fit->radius() - std::sqrt(600.0)) / kRuns;
        by_start += (start->radius() - std::sqrt(600.0)) / kRuns;
    }
    EXPECT_LT(std::abs(by_fit), 0.02);
    EXPECT_GT(std::abs(by_start), 0.1);
}

TEST(EllipseFit, LeavesOutWhatIsFarOff) {
    auto field = readingsOf(kAskew, 0.2, 3);
    for (std::size_t i = 100; i < 140; ++i) field[i] = {500.0, -300.0};
    const auto fit = fitEllipse({field, {0}});
    ASSERT_TRUE(fit);
    expectSame(rangeOf(fit->ellipse), kAskew, 0.1);
    EXPECT_EQ(fit->weight.segment(100, 40).maxCoeff(), 0.0);
}

TEST(EllipseFit, IsNoneForALineOnePlaceAndAFew) {
    std::vector<Eigen::Vector2d> line;
    for (int i = 0; i < 100; ++i) line.emplace_back(0.1 * i, 3.0 - 0.2 * i);
    EXPECT_FALSE(fitEllipse({line, {0}}));
    EXPECT_FALSE(fitEllipse({std::vector<Eigen::Vector2d>(100, Eigen::Vector2d(1.0, 2.0)), {0}}));
    EXPECT_FALSE(fitEllipse({readingsOf(kAskew, 0.0, 1, 10), {0}}));
    EXPECT_FALSE(fitEllipse({}));
}

}  // namespace
}  // namespace hedr
