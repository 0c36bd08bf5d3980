#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/geometry/angle.h"
#include "core/site/control_points.h"
#include "tests/core/site/random_control_points.h"

namespace hedr {
namespace {

using namespace test;

// How far a point fixes the fit by itself. A blunder there bends the fit instead of showing, so
// an operator spreads the points; above 0.6 a blunder of ten sigma is not sure to be seen.
double greatestLeverage(const Points& points) {
    Eigen::MatrixXd plan(points.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        plan.row(static_cast<Eigen::Index>(i)) << points[i].plan.x, points[i].plan.y;
    }
    plan.rowwise() -= plan.colwise().mean().eval();
    const double share = plan.rowwise().squaredNorm().maxCoeff() / plan.squaredNorm();
    return share + 1.0 / static_cast<double>(points.size());
}

TEST(ControlPoints, NameTheOneBlunderOfTenSigmaAmongEightInEveryTrial) {
    constexpr int kTrials = 5000;
    constexpr double kSigma_m = 0.05;
    int probable = 0;
    for (int seed = 0; seed < kTrials; ++seed) {
        RandomBits random(static_cast<std::uint64_t>(seed));
        const PlanPlacement truth = randomPlacement(random);
        Points points;
        do {
            points = randomPoints(random, 8, truth, kSigma_m);
        } while (greatestLeverage(points) > 0.6);
        const auto wrong = std::uniform_int_distribution<std::size_t>(0, 7)(random);
        const double length_m = kSigma_m * uniform(random, 10.0, 100.0);
        const double angle_rad = uniform(random, -kPi, kPi);
        points[wrong].world = points[wrong].world + Vector<World>{length_m * std::cos(angle_rad),
                                                                  length_m * std::sin(angle_rad)};
        const auto fit = fitPlacement(points, kHeight_px);
        if (!fit) continue;  // counted as not named
        EXPECT_EQ(fit->worst, wrong) << "seed " << seed;
        if (fit->worst == wrong && fit->blunder == Blunder::kProbable) ++probable;
    }
    RecordProperty("called_probable", probable);
    EXPECT_GE(probable, kTrials * 99 / 100);
}

TEST(ControlPoints, SeldomCallAGoodPointABlunder) {
    constexpr int kTrials = 5000;
    int called = 0;
    for (int seed = 0; seed < kTrials; ++seed) {
        RandomBits random(static_cast<std::uint64_t>(seed));
        const auto points = randomPoints(random, 4 + static_cast<std::size_t>(seed % 7),
                                         randomPlacement(random), 0.05);
        const auto fit = fitPlacement(points, kHeight_px);
        ASSERT_TRUE(fit) << fit.error().detail;
        if (fit->blunder == Blunder::kProbable) ++called;
    }
    EXPECT_LE(called, kTrials * 3 / 200);  // 1 % wanted
}

TEST(ControlPoints, NameThePointOfLeverageWhereItsResidualIsNotTheLargest) {
    // Seven points in one corner, one far away: the far one pulls the fit to itself.
    RandomBits random(5);
    int smaller = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Points points = randomPoints(random, 8, {0.05, {{3.0, 4.0}, 0.3}}, 0.002);
        for (std::size_t i = 0; i < 7; ++i) {
            points[i].plan = {0.3 * points[i].plan.x, 0.3 * points[i].plan.y};
            points[i].world = placed(points[i].plan, {0.05, {{3.0, 4.0}, 0.3}});
        }
        points[7].plan = {1900.0, 1400.0};
        points[7].world = placed(points[7].plan, {0.05, {{3.0, 4.0}, 0.3}});
        points[7].world.x += 1.0;
        const auto fit = fitPlacement(points, kHeight_px);
        ASSERT_TRUE(fit);
        EXPECT_EQ(fit->worst, 7U);
        for (std::size_t i = 0; i < 7; ++i) {
            if (fit->residuals_m[i].length() > fit->residuals_m[7].length()) {
                ++smaller;
                break;
            }
        }
    }
    EXPECT_GT(smaller, 20);
}

}  // namespace
}  // namespace hedr
