#include "ui/calibration/plot_axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QStringList>
#include <cmath>

namespace hedr {
namespace {

PlotAxis axisOf(Extent extent, bool logarithmic = false) {
    PlotAxis axis = plotAxis(extent, logarithmic, 600.0, 60.0);
    axis.from_px = 50.0;
    axis.to_px = 650.0;
    return axis;
}

QStringList labels(const PlotAxis& axis) {
    QStringList all;
    for (const double tick : axis.ticks()) all << axis.label(tick);
    return all;
}

TEST(PlotAxis, EndsAtRoundTicks) {
    const PlotAxis axis = axisOf({0.13, 3.87});
    EXPECT_EQ(axis.low, 0.0);
    EXPECT_EQ(axis.high, 4.0);
    EXPECT_EQ(axis.step, 0.5);
    EXPECT_EQ(labels(axis).join(' '), "0.0 0.5 1.0 1.5 2.0 2.5 3.0 3.5 4.0");
}

TEST(PlotAxis, SignsItsLabelsWhereBothSignsAreThere) {
    const PlotAxis axis = plotAxis({-0.19, 0.2}, false, 300.0, 60.0);
    EXPECT_EQ(labels(axis).join(' '), "−0.2 −0.1 0.0 +0.1 +0.2");
}

TEST(PlotAxis, GoesByDecadesWhereItIsLogarithmic) {
    const PlotAxis axis = axisOf({0.02, 300.0}, true);
    EXPECT_EQ(labels(axis).join(' '), "0.01 0.1 1 10 100 1000");
    EXPECT_EQ(axis.minorTicks().size(), 5U * 8U);
    EXPECT_NEAR(axis.pixelOf(0.01), 50.0, 1e-9);
    EXPECT_NEAR(axis.pixelOf(0.1), 170.0, 1e-9);
    EXPECT_TRUE(std::isnan(axis.pixelOf(0.0)));
    EXPECT_TRUE(std::isnan(axis.pixelOf(-1.0)));
}

TEST(PlotAxis, LeavesOutDecadesWhereThereIsNoRoom) {
    const PlotAxis axis = plotAxis({1e-9, 1e6}, true, 300.0, 60.0);
    EXPECT_EQ(labels(axis).join(' '), "10⁻⁹ 10⁻⁶ 0.001 1 1000 10⁶");
    EXPECT_EQ(axis.minorTicks().size(), 10U) << "the decades between";
}

TEST(PlotAxis, HasRoomAroundASingleValue) {
    const PlotAxis five = axisOf({5.0, 5.0});
    EXPECT_LT(five.low, 5.0);
    EXPECT_GT(five.high, 5.0);
    const PlotAxis nothing = axisOf({});
    EXPECT_EQ(nothing.low, 0.0);
    EXPECT_EQ(nothing.high, 1.0);
    EXPECT_EQ(axisOf({1.0, 1.0}, true).ticks().size(), 2U);
}

RC_GTEST_PROP(PlotAxis, HoldsEveryValueAndFewTicks, ()) {
    const double a = *rc::gen::arbitrary<int>() * std::pow(10.0, *rc::gen::inRange(-12, 4));
    const double b = *rc::gen::arbitrary<int>() * std::pow(10.0, *rc::gen::inRange(-12, 4));
    Extent extent;
    extent.add(a);
    extent.add(b);
    const PlotAxis axis = axisOf(extent);
    const double slack_px = 1e-3;
    RC_ASSERT(axis.pixelOf(extent.low) >= 50.0 - slack_px);
    RC_ASSERT(axis.pixelOf(extent.high) <= 650.0 + slack_px);
    RC_ASSERT(axis.ticks().size() >= 2U);
    RC_ASSERT(axis.ticks().size() <= 13U);
}

TEST(PlotAxis, GivesBothTheScaleOfTheWiderOne) {
    PlotAxis x = plotAxis({0.0, 10.0}, false, 500.0, 60.0);
    x.to_px = 500.0;
    PlotAxis y = plotAxis({0.0, 1.0}, false, 200.0, 60.0);
    y.from_px = 200.0;
    y.to_px = 0.0;
    giveSameScale(x, y);
    EXPECT_EQ(x.low, 0.0);
    EXPECT_EQ(x.high, 10.0);
    EXPECT_NEAR(x.pixelOf(1.0) - x.pixelOf(0.0), y.pixelOf(0.0) - y.pixelOf(1.0), 1e-9);
    EXPECT_NEAR(0.5 * (y.low + y.high), 0.5, 1e-9) << "about its middle";
    EXPECT_EQ(x.step, y.step);
}

}  // namespace
}  // namespace hedr
