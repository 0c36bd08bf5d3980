#include "core/calibration/compass/ellipsoid_fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

Ellipsoid askew() {
    Ellipsoid truth;
    truth.centre = {30.0, -40.0, -27.0};
    truth.iron << 1.02, -0.05, 0.02, -0.05, 0.93, 0.03, 0.02, 0.03, 1.1;
    truth.iron /= std::cbrt(truth.iron.determinant());
    truth.strength = 50.0;
    return truth;
}

// Along a winding path over the sphere, as a hand turns it.
std::vector<Eigen::Vector3d> readingsOf(const Ellipsoid& truth, double noise, std::uint64_t seed,
                                        int count = 600) {
    Random random(seed);
    const Eigen::Matrix3d distort = truth.iron.inverse();
    std::vector<Eigen::Vector3d> field;
    for (int i = 0; i < count; ++i) {
        const double height = 2.0 * (i + 0.5) / count - 1.0;
        const double around_rad = 2.0 * kPi * 11.3 * i / count;
        const double level = std::sqrt(1.0 - height * height);
        const Eigen::Vector3d unit(level * std::cos(around_rad), level * std::sin(around_rad),
                                   height);
        field.emplace_back(truth.centre + truth.strength * (distort * unit) +
                           noise *
                               Eigen::Vector3d(random.normal(), random.normal(), random.normal()));
    }
    return field;
}

TEST(EllipsoidFit, IsExactWithoutNoise) {
    const Ellipsoid truth = askew();
    const auto fit = fitEllipsoid(readingsOf(truth, 0.0, 1));
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->ellipsoid.centre - truth.centre).norm(), 1e-5);
    EXPECT_LT((fit->ellipsoid.iron - truth.iron).norm(), 1e-6);
    EXPECT_NEAR(fit->ellipsoid.strength, 50.0, 1e-5);
    EXPECT_LT(fit->gaps, 0.05);
}

double shareCovered(int runs) {
    const Ellipsoid truth = askew();
    int covered = 0;
    for (int run = 0; run < runs; ++run) {
        const auto fit = fitEllipsoid(readingsOf(truth, 0.7, static_cast<std::uint64_t>(run) + 1));
        EXPECT_TRUE(fit);
        for (std::size_t axis = 0; fit && axis < 3; ++axis) {
            const double centre = truth.centre(static_cast<Eigen::Index>(axis));
            covered += fit->centre.at(axis).interval().contains(centre) ? 1 : 0;
        }
    }
    std::printf("covered %.1f %%\n", 100.0 * covered / (3.0 * runs));
    return covered / (3.0 * runs);
}

TEST(EllipsoidFit, CoversItsCentreInFewRecords) { EXPECT_GT(shareCovered(40), 0.88); }
TEST(EllipsoidFit, DISABLED_CoversItsCentreAsItSays) {
    const double share = shareCovered(2000);
    EXPECT_GT(share, 0.93);
    EXPECT_LT(share, 0.97);
}

TEST(EllipsoidFit, LeavesOutWhatIsFarOff) {
    const Ellipsoid truth = askew();
    auto field = readingsOf(truth, 0.3, 4);
    for (std::size_t i = 200; i < 220; ++i) field[i] += Eigen::Vector3d(40.0, 0.0, 10.0);
    const auto fit = fitEllipsoid(field);
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->ellipsoid.centre - truth.centre).norm(), 0.3);
    EXPECT_NEAR(fit->outliers, 20.0 / 600.0, 0.01);
}

TEST(EllipsoidFit, IsNoneForACircleOnePlaceAndAFew) {
    std::vector<Eigen::Vector3d> circle;
    for (int i = 0; i < 200; ++i) circle.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 2.0);
    EXPECT_LT(roundness(circle), 1e-6);
    EXPECT_FALSE(fitEllipsoid(std::vector<Eigen::Vector3d>(200, Eigen::Vector3d(1.0, 2.0, 3.0))));
    EXPECT_FALSE(fitEllipsoid(readingsOf(askew(), 0.0, 1, 20)));
    EXPECT_FALSE(fitEllipsoid({}));
    EXPECT_GT(roundness(readingsOf(askew(), 0.0, 1)), 0.7);
}

}  // namespace
}  // namespace hedr
