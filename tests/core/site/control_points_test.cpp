#include "core/site/control_points.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "tests/core/site/random_control_points.h"

namespace hedr {
namespace {

using namespace test;

// Resolution, heading and origin by Gauss-Newton with QR over all points; where a value is fixed,
// its column is left out. World coordinates are taken from the first point only.
Eigen::Vector4d independentFit(const Points& points, const FitOptions& options,
                               Eigen::Vector4d guess) {
    const Point<World> base = points.front().world;
    guess.tail<2>() -= Eigen::Vector2d(base.x, base.y);
    std::vector<int> free;
    if (!options.fixed_resolution_m) free.push_back(0);
    if (!options.fixed_heading_rad) free.push_back(1);
    free.push_back(2);
    free.push_back(3);
    guess[0] = options.fixed_resolution_m.value_or(guess[0]);
    guess[1] = options.fixed_heading_rad.value_or(guess[1]);
    for (int round = 0; round < 60; ++round) {
        Eigen::MatrixXd all(2 * points.size(), 4);
        Eigen::VectorXd rest(2 * points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
            const Eigen::Vector2d u(points[i].plan.x, kHeight_px - points[i].plan.y);
            const Eigen::Rotation2Dd turn(guess[1]);
            const Eigen::Vector2d turned = turn * u;
            const Vector<World> w = points[i].world - base;
            all.block<2, 1>(row, 0) = turned;
            all.block<2, 1>(row, 1) = guess[0] * Eigen::Vector2d(-turned.y(), turned.x());
            all.block<2, 2>(row, 2).setIdentity();
            rest.segment<2>(row) = Eigen::Vector2d(w.x, w.y) - guess[0] * turned - guess.tail<2>();
        }
        const Eigen::MatrixXd some = all(Eigen::all, free);
        const Eigen::VectorXd step = some.colPivHouseholderQr().solve(rest);
        for (std::size_t k = 0; k < free.size(); ++k) {
            guess[free[k]] += step[static_cast<Eigen::Index>(k)];
        }
    }
    guess.tail<2>() += Eigen::Vector2d(base.x, base.y);
    return guess;
}

Eigen::Vector4d asVector(const PlanPlacement& p) {
    return {p.resolution_m, p.origin.heading_rad, p.origin.position.x, p.origin.position.y};
}

void expectSame(const PlanPlacement& placement, const Eigen::Vector4d& other, double size_m) {
    constexpr double kRelative = 1e-9;
    EXPECT_NEAR(placement.resolution_m, other[0], kRelative * other[0]);
    EXPECT_NEAR(wrapAngle(placement.origin.heading_rad - other[1]), 0.0, kRelative);
    EXPECT_NEAR(placement.origin.position.x, other[2], kRelative * size_m);
    EXPECT_NEAR(placement.origin.position.y, other[3], kRelative * size_m);
}

TEST(ControlPoints, AgreeWithTheLinearSystemSolvedByQr) {
    RandomBits random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const PlanPlacement truth = randomPlacement(random);
        const Points points = randomPoints(random, 2 + trial % 9, truth, 0.3);
        // world = [a -b; b a] plan + t, Eigen's generic QR.
        Eigen::MatrixXd system(2 * points.size(), 4);
        Eigen::VectorXd world(2 * points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
            const double x = points[i].plan.x;
            const double y = kHeight_px - points[i].plan.y;
            system.middleRows(row, 2) << x, -y, 1, 0, y, x, 0, 1;
            world.segment<2>(row) << points[i].world.x, points[i].world.y;
        }
        const Eigen::Vector4d solved = system.colPivHouseholderQr().solve(world);
        const auto fit = fitPlacement(points, kHeight_px);
        ASSERT_TRUE(fit) << fit.error().detail;
        const double size_m = 1000.0 + 2500.0 * truth.resolution_m;
        expectSame(fit->placement,
                   {std::hypot(solved[0], solved[1]), std::atan2(solved[1], solved[0]), solved[2],
                    solved[3]},
                   size_m);
    }
}

TEST(ControlPoints, AgreeWithGaussNewtonWhateverIsFixedEvenInUtm) {
    RandomBits random(2);
    for (int trial = 0; trial < 200; ++trial) {
        const PlanPlacement truth = randomPlacement(random, 5e6);
        const Points points = randomPoints(random, 3 + trial % 8, truth, 0.2);
        for (int locks = 0; locks < 4; ++locks) {
            FitOptions options;
            if (locks & 1) options.fixed_resolution_m = 1.02 * truth.resolution_m;
            if (locks & 2) options.fixed_heading_rad = truth.origin.heading_rad + 0.03;
            const auto fit = fitPlacement(points, kHeight_px, options);
            ASSERT_TRUE(fit) << fit.error().detail;
            expectSame(fit->placement, independentFit(points, options, asVector(truth)), 5e6);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const auto r = placed(points[i].plan, fit->placement) - points[i].world;
                EXPECT_NEAR(fit->residuals_m[i].x, r.x, 1e-8);
                EXPECT_NEAR(fit->residuals_m[i].y, r.y, 1e-8);
            }
        }
    }
}

RC_GTEST_PROP(ControlPoints, RecoverAnyPlacementExactly, (std::uint64_t seed)) {
    RandomBits random(seed);
    const PlanPlacement truth = randomPlacement(random);
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(2, 12));
    const Points points = randomPoints(random, count, truth, 0.0);
    RC_PRE((points[1].plan - points[0].plan).length() > 50.0);
    const auto fit = fitPlacement(points, kHeight_px);
    RC_ASSERT(fit.has_value());
    RC_ASSERT(fit->rms_m < 1e-8);
    RC_ASSERT(std::abs(fit->placement.resolution_m / truth.resolution_m - 1.0) < 1e-9);
    RC_ASSERT(std::abs(wrapAngle(fit->placement.origin.heading_rad - truth.origin.heading_rad)) <
              1e-9);
    RC_ASSERT((fit->placement.origin.position - truth.origin.position).length() < 1e-6);
    RC_ASSERT(fit->blunder == (count < 4 ? Blunder::kCannotTell : Blunder::kNone));
}

TEST(ControlPoints, GiveStandardErrorsThatTheScatterConfirms) {
    RandomBits random(7);
    const PlanPlacement truth{0.05, {{100.0, -50.0}, 0.4}};
    const Points still = randomPoints(random, 6, truth, 0.0);
    for (int locks = 0; locks < 4; ++locks) {
        FitOptions options;
        if (locks & 1) options.fixed_resolution_m = truth.resolution_m;
        if (locks & 2) options.fixed_heading_rad = truth.origin.heading_rad;
        Eigen::Vector4d scatter = Eigen::Vector4d::Zero();
        Eigen::Vector4d told = Eigen::Vector4d::Zero();
        for (int trial = 0; trial < 4000; ++trial) {
            std::normal_distribution<double> noise(0.0, 0.1);
            Points points = still;
            for (auto& p : points) p.world = p.world + Vector<World>{noise(random), noise(random)};
            const auto fit = fitPlacement(points, kHeight_px, options);
            ASSERT_TRUE(fit && fit->sigma);
            const PlacementSigma& s = *fit->sigma;
            scatter += (asVector(fit->placement) - asVector(truth)).cwiseAbs2();
            told += Eigen::Vector4d(s.resolution_m, s.heading_rad, s.origin_m.x, s.origin_m.y)
                        .cwiseAbs2();
        }
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(told[k], scatter[k], 0.1 * scatter[k]) << k;
    }
}

TEST(ControlPoints, HaveNoStandardErrorAndNoWorstPointWhereTwoFixAll) {
    const Points two = {{"", {0, 0}, {0, 0}}, {"", {100, 0}, {5, 0}}};
    const auto fit = fitPlacement(two, kHeight_px);
    ASSERT_TRUE(fit);
    EXPECT_FALSE(fit->sigma);
    EXPECT_FALSE(fit->worst);
    EXPECT_EQ(fit->blunder, Blunder::kCannotTell);
    EXPECT_TRUE(fit->all_on_a_line);
    EXPECT_NEAR(fit->placement.resolution_m, 0.05, 1e-15);
    EXPECT_NEAR(fit->rms_m, 0.0, 1e-12);
}

TEST(ControlPoints, CannotSingleOutOneOfThree) {
    const Points three = {
        {"", {0, 0}, {0, 0}}, {"", {1000, 0}, {50, 0}}, {"", {0, 1000}, {3, -50}}};
    const auto fit = fitPlacement(three, kHeight_px);
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->sigma);
    EXPECT_FALSE(fit->worst);
    EXPECT_EQ(fit->blunder, Blunder::kCannotTell);
    EXPECT_FALSE(fit->all_on_a_line);
}

TEST(ControlPoints, FitOnALineWithANote) {
    const PlanPlacement truth{0.1, {{7.0, 8.0}, 1.0}};
    Points points;
    for (int i = 0; i < 5; ++i) {
        const Point<Plan> p{100.0 * i, 30.0 * i};
        points.push_back({"", p, placed(p, truth)});
    }
    const auto fit = fitPlacement(points, kHeight_px);
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->all_on_a_line);
    EXPECT_NEAR(fit->placement.resolution_m, 0.1, 1e-12);
}

void expectRefused(const Result<PlanFit>& fit, const std::string& sentence) {
    ASSERT_FALSE(fit) << sentence;
    EXPECT_EQ(fit.error().code, ErrorCode::kBadValue);
    EXPECT_NE((fit.error().subject + ": " + fit.error().detail).find(sentence), std::string::npos)
        << fit.error().subject << ": " << fit.error().detail;
}

TEST(ControlPoints, RefuseAMirroredPlan) {
    RandomBits random(9);
    for (int trial = 0; trial < 500; ++trial) {
        Points points = randomPoints(random, 3 + static_cast<std::size_t>(trial % 6),
                                     {0.05, {{}, uniform(random, -3.0, 3.0)}}, 0.0);
        const auto upright = fitPlacement(points, kHeight_px);
        ASSERT_TRUE(upright);
        if (upright->all_on_a_line) continue;
        for (auto& p : points) p.world.x = -p.world.x;
        expectRefused(fitPlacement(points, kHeight_px), "only a mirrored plan");
    }
}

TEST(ControlPoints, RefuseATriangleWithTwoPointsSwapped) {
    Points points = {{"", {0, 0}, {0, 0}}, {"", {1000, 0}, {50, 0}}, {"", {500, 800}, {25, -40}}};
    std::swap(points[0].world, points[1].world);
    expectRefused(fitPlacement(points, kHeight_px), "two of them are swapped");
}

TEST(ControlPoints, RefuseWhatIsNoPlacementInOneSentence) {
    const ControlPoint a{"door", {0, 0}, {0, 0}};
    const ControlPoint b{"", {100, 0}, {5, 0}};
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInf = std::numeric_limits<double>::infinity();
    const auto fit = [](const Points& points, const FitOptions& options = {}) {
        return fitPlacement(points, kHeight_px, options);
    };
    expectRefused(fit({}), "two at least");
    expectRefused(fit({a}), "two at least");
    expectRefused(fit({a, a}), "point 1 (door) and point 2 (door): they are the same point");
    expectRefused(fit({a, b, {"", a.plan, {9, 9}}}), "one place on the plan, but two");
    expectRefused(fit({a, b, {"", {50, 50}, b.world}}), "one place in the world, but two");
    expectRefused(fit({a, {"", {kNan, 0}, {5, 0}}}), "point 2: a coordinate is not a number");
    expectRefused(fit({a, {"", {1, 0}, {5, -kInf}}}), "point 2: a coordinate is not a number");
    expectRefused(fit({a, {"", {1, 0}, {1e300, 0}}}), "point 2: a coordinate is not a number");
    expectRefused(fit({a, b}, {0.0, {}}), "fixed resolution");
    expectRefused(fit({a, b}, {kNan, {}}), "fixed resolution");
    expectRefused(fit({a, b}, {{}, kInf}), "fixed heading");
    expectRefused(fit({a, b}, {{}, kPi}), "the other way round");
}

TEST(ControlPoints, RefusePointsThatContradictEachOther) {
    // Five on a circle whose counterparts go round twice: turned by any angle they fit as badly.
    Points points;
    for (int i = 0; i < 5; ++i) {
        const double angle_rad = 0.4 * kPi * i;
        points.push_back({"",
                          {100.0 * std::cos(angle_rad), 100.0 * std::sin(angle_rad)},
                          {5.0 * std::cos(2.0 * angle_rad), 5.0 * std::sin(2.0 * angle_rad)}});
    }
    expectRefused(fitPlacement(points, kHeight_px), "contradict each other");
}

TEST(ControlPoints, NeverGiveNonsenseForAnyNumbers) {
    RandomBits random(11);
    const std::array values = {0.0,   1.0,  -1.0,  1e-300, 1e9,
                               -1e9,  1e-9, 1e300, 0.5,    std::numeric_limits<double>::infinity(),
                               3e-17, 7.0};
    std::uniform_int_distribution<std::size_t> pick(0, values.size() - 1);
    for (int trial = 0; trial < 20000; ++trial) {
        Points points(2 + static_cast<std::size_t>(trial % 4));
        for (auto& p : points) {
            p.plan = {values[pick(random)], values[pick(random)]};
            p.world = {values[pick(random)], values[pick(random)]};
        }
        const auto fit = fitPlacement(points, kHeight_px);
        if (!fit) continue;
        EXPECT_TRUE(asVector(fit->placement).allFinite());
        EXPECT_GT(fit->placement.resolution_m, 0.0);
        EXPECT_TRUE(std::isfinite(fit->rms_m) && std::isfinite(fit->chance));
    }
}

TEST(TwoPointsAndDistance, ScaleAboutTheFirstPoint) {
    const PlanPlacement before{0.05, {{10.0, 20.0}, 0.7}};
    const Point<Plan> a{300.0, 400.0};
    const Point<Plan> b{600.0, 800.0};
    const auto after = fitTwoPointsAndDistance(a, b, 12.5, kHeight_px, before);
    ASSERT_TRUE(after);
    EXPECT_NEAR(after->resolution_m, 0.025, 1e-15);
    EXPECT_EQ(after->origin.heading_rad, 0.7);
    EXPECT_NEAR((placed(a, *after) - placed(a, before)).length(), 0.0, 1e-12);
    EXPECT_NEAR((placed(a, *after) - placed(b, *after)).length(), 12.5, 1e-12);
}

TEST(TwoPointsAndDistance, RefuseOnePlaceAndNoDistance) {
    EXPECT_FALSE(fitTwoPointsAndDistance({1, 2}, {1, 2}, 3.0, kHeight_px, {}));
    EXPECT_FALSE(fitTwoPointsAndDistance({1, 2}, {3, 2}, 0.0, kHeight_px, {}));
    EXPECT_FALSE(fitTwoPointsAndDistance({1, 2}, {3, 2}, -1.0, kHeight_px, {}));
    EXPECT_FALSE(fitTwoPointsAndDistance({1, 2}, {3, 2}, std::numeric_limits<double>::infinity(),
                                         kHeight_px, {}));
}

}  // namespace
}  // namespace hedr
