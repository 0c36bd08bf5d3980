#include "core/simulation/wheels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

constexpr VehicleGeometry kGeometry{0.1, 0.2, 0.5, 1000.0};

TEST(Wheels, CountRevolutionsOfEachByItsOwnSize) {
    EXPECT_EQ(wheelCounts(kGeometry, 0.10015 * kPi, 0.10015 * kPi), (WheelTicks{1001, 500}));
}

TEST(Wheels, RoundCountsDownOnBothSidesOfZero) {
    const double half_m = 0.0005 * 0.1 * kPi;
    EXPECT_EQ(wheelCounts(kGeometry, half_m, 0.0).left, 0);
    EXPECT_EQ(wheelCounts(kGeometry, -half_m, 0.0).left, -1);
}

TEST(Wheels, ShareATurnBetweenThem) {
    Random random(1);
    Wheels wheels({0.2, 0.2, 0.5, 1000.0}, 0.0);
    wheels.move(0.0, 2.0, random);
    EXPECT_EQ(wheels.ticks(), wheelCounts({0.2, 0.2, 0.5, 1000.0}, -0.5, 0.5));
}

TEST(Wheels, OnAnUnevenFloorErrByTheRootOfTheWay) {
    double squares = 0.0;
    constexpr int kRuns = 400;
    for (int run = 0; run < kRuns; ++run) {
        Random random(static_cast<std::uint64_t>(run));
        Wheels wheels({0.2, 0.2, 0.5, 1e6}, 0.001);
        for (int step = 0; step < 100; ++step) wheels.move(0.04, 0.0, random);
        const double way_m = static_cast<double>(wheels.ticks().left) * 0.2 * kPi / 1e6;
        squares += (way_m - 4.0) * (way_m - 4.0) / kRuns;
    }
    EXPECT_NEAR(std::sqrt(squares), 0.002, 0.0002);
}

}  // namespace
}  // namespace hedr
