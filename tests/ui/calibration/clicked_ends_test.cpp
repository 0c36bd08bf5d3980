#include "ui/calibration/clicked_ends.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

// The first side goes along -y of the map.
ClickedEnds withAxes() {
    ClickedEnds ends;
    EXPECT_TRUE(ends.add({10.0, 5.0}));
    EXPECT_TRUE(ends.add({10.0, 1.0}));
    return ends;
}

TEST(ClickedEnds, AreInTheAxesOfTheStart) {
    ClickedEnds ends = withAxes();
    ASSERT_EQ(ends.next(), ClickedEnds::Next::kEnd);
    EXPECT_TRUE(ends.add({10.25, 4.5}));
    const auto found = ends.ends();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].run, 1U);
    EXPECT_DOUBLE_EQ(found[0].way.x, 0.5);
    EXPECT_DOUBLE_EQ(found[0].way.y, 0.25);
}

TEST(ClickedEnds, AskForOneAfterTheOther) {
    ClickedEnds ends;
    EXPECT_EQ(ends.next(), ClickedEnds::Next::kStart);
    EXPECT_FALSE(ends.wayTo({0.0, 0.0}));
    ends.skipRun();
    EXPECT_EQ(ends.next(), ClickedEnds::Next::kStart) << "a start cannot be skipped";
    EXPECT_TRUE(ends.add({0.0, 0.0}));
    EXPECT_EQ(ends.next(), ClickedEnds::Next::kAhead);
    EXPECT_FALSE(ends.wayTo({0.0, 0.0}));
    EXPECT_TRUE(ends.add({0.0, 2.0}));
    EXPECT_EQ(ends.nextRun(), 1U);
    ends.skipRun();
    EXPECT_EQ(ends.nextRun(), 2U);
    EXPECT_TRUE(ends.add({0.1, 0.1}));
    ASSERT_EQ(ends.ends().size(), 1U);
    EXPECT_EQ(ends.ends()[0].run, 2U);
}

TEST(ClickedEnds, NeedAFirstSideThatTellsItsDirection) {
    ClickedEnds ends;
    EXPECT_TRUE(ends.add({0.0, 0.0}));
    EXPECT_FALSE(ends.add({0.6, 0.7}));
    EXPECT_EQ(ends.next(), ClickedEnds::Next::kAhead);
    EXPECT_TRUE(ends.move(0, {0.0, 3.0}));
    EXPECT_TRUE(ends.add({0.6, 0.7}));
    EXPECT_FALSE(ends.move(0, {0.6, 1.0}));
    EXPECT_FALSE(ends.move(1, {0.0, 3.0}));
    EXPECT_FALSE(ends.move(2, {0.0, 3.0})) << "there is none";
}

TEST(ClickedEnds, GoOnAfterTheRunsThatAreKnown) {
    ClickedEnds ends(4);
    EXPECT_TRUE(ends.add({0.0, 0.0}));
    EXPECT_TRUE(ends.add({2.0, 0.0}));
    EXPECT_EQ(ends.nextRun(), 4U);
    EXPECT_TRUE(ends.add({0.1, 0.0}));
    EXPECT_EQ(ends.ends().at(0).run, 4U);
    EXPECT_EQ(ends.nextRun(), 5U);
}

TEST(ClickedEnds, MoveWithTheAxes) {
    ClickedEnds ends = withAxes();
    EXPECT_TRUE(ends.add({10.0, 5.0}));
    EXPECT_TRUE(ends.move(0, {10.0, 5.5}));
    EXPECT_DOUBLE_EQ(ends.ends()[0].way.x, 0.5);
    EXPECT_TRUE(ends.move(2, {10.0, 5.5}));
    EXPECT_DOUBLE_EQ(ends.ends()[0].way.x, 0.0);
}

}  // namespace
}  // namespace hedr
