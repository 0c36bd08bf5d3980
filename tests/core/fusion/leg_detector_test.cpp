#include "core/fusion/leg_detector.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

using Change = LegDetector::Change;

MotionSegment piece(double distance_m, double turn_deg) {
    MotionSegment segment;
    segment.add({.dt_s = 0.5,
                 .distance_m = distance_m,
                 .sensed_rad = radFromDeg(turn_deg),
                 .believed_rad = radFromDeg(turn_deg)});
    return segment;
}

TEST(LegDetector, BeginsALegAfterAStraightWayAndEndsItInATurn) {
    LegDetector detector({.begin_m = 1.0});
    EXPECT_EQ(detector.add(piece(0.4, 0.0)), Change::kNone);
    EXPECT_EQ(detector.add(piece(0.4, 2.0)), Change::kNone);
    EXPECT_EQ(detector.add(piece(0.4, -2.0)), Change::kBegun);
    EXPECT_EQ(detector.add(piece(0.4, 0.0)), Change::kNone);
    EXPECT_EQ(detector.add(piece(0.2, 20.0)), Change::kEnded);
    EXPECT_FALSE(detector.onLeg());
}

TEST(LegDetector, CountsBackwardDrivingToo) {
    LegDetector detector({.begin_m = 1.0});
    for (int i = 0; i < 2; ++i) EXPECT_EQ(detector.add(piece(-0.4, 0.0)), Change::kNone);
    EXPECT_EQ(detector.add(piece(-0.4, 0.0)), Change::kBegun);
}

TEST(LegDetector, TakesToAndFroOnOneLineForOneLine) {
    LegDetector detector({.begin_m = 1.0});
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(detector.add(piece(i % 2 == 0 ? 0.4 : -0.4, 0.0)), Change::kNone);
    detector.add(piece(0.8, 0.0));
    EXPECT_NEAR(detector.newGround_m(), 0.4, 1e-12);
    detector.add(piece(-0.8, 0.0));
    EXPECT_EQ(detector.newGround_m(), 0.0);
}

TEST(LegDetector, SeesNoLegInACurve) {
    LegDetector detector({.begin_m = 1.8});
    for (int i = 0; i < 100; ++i) EXPECT_EQ(detector.add(piece(0.3, 2.5)), Change::kNone);
}

TEST(LegDetector, EndsALegThatBendsAwaySlowly) {
    LegDetector detector({});
    for (int i = 0; i < 20; ++i) detector.add(piece(0.3, 0.0));
    ASSERT_TRUE(detector.onLeg());
    for (int i = 0; i < 20; ++i) detector.add(piece(0.3, 3.0));
    EXPECT_FALSE(detector.onLeg());
}

TEST(LegDetector, KeepsALegThroughZigzag) {
    LegDetector detector({});
    for (int i = 0; i < 8; ++i) detector.add(piece(0.3, 0.0));
    for (int i = 0; i < 200; ++i)
        EXPECT_EQ(detector.add(piece(0.3, i % 8 < 4 ? 1.5 : -1.5)), Change::kNone);
    EXPECT_TRUE(detector.onLeg());
}

}  // namespace
}  // namespace hedr
