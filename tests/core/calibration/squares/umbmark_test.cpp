#include "core/calibration/squares/umbmark.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr VehicleGeometry kGeometry{0.15, 0.15, 0.34, 2000.0};
constexpr double kSide_m = 4.0;

// The small-angle end points of the paper for errors of both types.
UmbmarkReturns returnsFor(double alpha_rad, double beta_rad) {
    const double a = -2.0 * kSide_m * alpha_rad;
    const double b = -2.0 * kSide_m * beta_rad;
    return {.clockwise = {{a + b, -a + b}}, .counter_clockwise = {{a - b, a + b}}};
}

TEST(Umbmark, OfAWrongWheelbaseFindsItAlone) {
    const auto fit = fitUmbmark(returnsFor(0.02, 0.0), kSide_m, kGeometry).value();
    EXPECT_NEAR(fit.alpha_rad, 0.02, 1e-12);
    EXPECT_NEAR(fit.wheelbase_ratio, 0.5 * kPi / (0.5 * kPi - 0.02), 1e-12);
    EXPECT_NEAR(fit.corrected.wheelbase_m, 0.34 * fit.wheelbase_ratio, 1e-12);
    EXPECT_EQ(fit.diameter_ratio, 1.0);
    EXPECT_NEAR(fit.largest_systematic_error_m, std::sqrt(2.0) * 0.16, 1e-12);
}

TEST(Umbmark, OfUnequalWheelsFindsThemAloneAndKeepsTheirMean) {
    const auto fit = fitUmbmark(returnsFor(0.0, 0.03), kSide_m, kGeometry).value();
    const double radius_m = 0.5 * kSide_m / std::sin(0.015);
    EXPECT_NEAR(fit.beta_rad, 0.03, 1e-12);
    EXPECT_NEAR(fit.diameter_ratio, (radius_m + 0.17) / (radius_m - 0.17), 1e-12);
    EXPECT_EQ(fit.wheelbase_ratio, 1.0);
    const VehicleGeometry& g = fit.corrected;
    EXPECT_NEAR(g.right_wheel_diameter_m / g.left_wheel_diameter_m, fit.diameter_ratio, 1e-12);
    EXPECT_NEAR(g.left_wheel_diameter_m + g.right_wheel_diameter_m, 0.30, 1e-12);
}

// Where beta is 0 the radius R of the paper is infinite.
TEST(Umbmark, OfAPerfectRobotChangesNothing) {
    const auto fit = fitUmbmark(returnsFor(0.0, 0.0), kSide_m, kGeometry).value();
    EXPECT_EQ(fit.diameter_ratio, 1.0);
    EXPECT_EQ(fit.wheelbase_ratio, 1.0);
    EXPECT_EQ(fit.largest_systematic_error_m, 0.0);
    EXPECT_EQ(fit.corrected, kGeometry);
    const auto near = fitUmbmark(returnsFor(0.0, 1e-12), kSide_m, kGeometry).value();
    EXPECT_NEAR(near.diameter_ratio, 1.0, 1e-12);
}

TEST(Umbmark, TakesTheCentreOfEachDirection) {
    const auto fit = fitUmbmark({.clockwise = {{0.1, 0.0}, {0.3, 0.2}},
                                 .counter_clockwise = {{0.0, -0.1}, {0.0, 0.1}, {0.3, 0.3}}},
                                kSide_m, kGeometry)
                         .value();
    EXPECT_NEAR(fit.clockwise_centre.x, 0.2, 1e-12);
    EXPECT_NEAR(fit.clockwise_centre.y, 0.1, 1e-12);
    EXPECT_NEAR(fit.counter_clockwise_centre.x, 0.1, 1e-12);
    EXPECT_NEAR(fit.counter_clockwise_centre.y, 0.1, 1e-12);
}

TEST(Umbmark, CorrectsWheelsThatAreBelievedUnequalByTheRatioThatIsLeft) {
    const VehicleGeometry believed{0.1, 0.2, 0.34, 2000.0};
    const auto fit = fitUmbmark(returnsFor(0.0, 0.03), kSide_m, believed).value();
    EXPECT_NEAR(fit.corrected.right_wheel_diameter_m / fit.corrected.left_wheel_diameter_m,
                2.0 * fit.diameter_ratio, 1e-12);
}

TEST(Umbmark, NamesTheDirectionThatWasNotDriven) {
    const auto fit =
        fitUmbmark({.clockwise = {{0.1, 0.0}}, .counter_clockwise = {}}, kSide_m, kGeometry);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().code, ErrorCode::kNoData);
    EXPECT_EQ(fit.error().subject, "counter-clockwise squares");
}

TEST(Umbmark, RefusesErrorsThatNoWheelbaseExplains) {
    const auto fit = fitUmbmark({.clockwise = {{-20.0, 0.0}}, .counter_clockwise = {{-20.0, 0.0}}},
                                kSide_m, kGeometry);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().code, ErrorCode::kBadValue);
}

}  // namespace
}  // namespace hedr
