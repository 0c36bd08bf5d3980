#include "core/fusion/heading_hypothesis.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace hedr {
namespace {

MotionSegment segmentOf(double dt_s, double distance_m, double turn_rad) {
    MotionSegment segment;
    for (int i = 0; i < 10; ++i)
        segment.add({.dt_s = dt_s / 10.0,
                     .distance_m = distance_m / 10.0,
                     .sensed_rad = turn_rad / 10.0,
                     .believed_rad = turn_rad / 10.0,
                     .witness_rad = turn_rad / 10.0});
    return segment;
}

TEST(HeadingHypothesis, MovesAlongAnArc) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({{1.0, 2.0}, 0.5 * kPi}, 0.01, 0.0, model);
    for (int i = 0; i < 100; ++i) hypothesis.move(segmentOf(0.1, 0.01 * kPi, 0.01 * kPi), model);
    EXPECT_NEAR(hypothesis.pose().heading_rad, 1.5 * kPi, 1e-9);
    EXPECT_NEAR(hypothesis.pose().position.x, 1.0 - 2.0, 1e-3);
    EXPECT_NEAR(hypothesis.pose().position.y, 2.0, 1e-3);
}

TEST(HeadingHypothesis, GrowsLessCertainAsItMoves) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({}, 0.01, 0.0, model);
    double before = -1.0;
    for (int i = 0; i < 20; ++i) {
        hypothesis.move(segmentOf(0.5, 0.3, 0.1), model);
        EXPECT_GT(hypothesis.covariance()(2, 2), before);
        before = hypothesis.covariance()(2, 2);
    }
    const Eigen::SelfAdjointEigenSolver<HeadingHypothesis::StateMatrix> solver(
        hypothesis.covariance());
    EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-12);
}

TEST(HeadingHypothesis, FindsTheBiasWhileItStands) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({}, 0.01, 0.0, model);
    for (int i = 0; i < 20; ++i) hypothesis.standStill(segmentOf(0.5, 0.0, 0.5 * 0.004), model);
    EXPECT_NEAR(hypothesis.mean()[HeadingHypothesis::kBias], 0.004, 1e-4);
    EXPECT_EQ(hypothesis.pose().heading_rad, 0.0);
}

// Gyro and encoders disagree by 0.01 rad/s: that is the gyro's bias.
TEST(HeadingHypothesis, LearnsTheBiasFromTheEncodersToo) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({}, 0.01, 0.0, model);
    for (int i = 0; i < 400; ++i) {
        MotionSegment segment = segmentOf(0.5, i % 2 == 0 ? 0.3 : -0.3, 0.0);
        segment.sensed_turn_rad = 0.5 * 0.01;
        hypothesis.move(segment, model);
        hypothesis.hearWitness(segment, 1e-4, model);
    }
    EXPECT_NEAR(hypothesis.mean()[HeadingHypothesis::kBias], 0.01, 0.002);
}

TEST(HeadingHypothesis, BelievesLittleOfASlippingWheel) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({}, 0.01, 0.0, model);
    for (int i = 0; i < 20; ++i) hypothesis.standStill(segmentOf(0.5, 0.0, 0.0), model);
    MotionSegment segment = segmentOf(0.5, 0.3, 0.0);
    segment.witness_turn_rad = radFromDeg(30.0);
    hypothesis.move(segment, model);
    hypothesis.hearWitness(segment, 1e-4, model);
    EXPECT_NEAR(degFromRad(hypothesis.heading_rad()), 0.0, 0.1);
    EXPECT_NEAR(degFromRad(hypothesis.mean()[HeadingHypothesis::kBias]), 0.0, 0.05);
}

// A scale that shrinks the zigzag would make it likelier, leg after leg.
TEST(HeadingHypothesis, LearnsNoScaleFromZigzag) {
    DrivingModel model;
    model.scale = 0.05;
    HeadingHypothesis hypothesis({}, 0.01, 0.0, model);
    hypothesis.beginLegAlong(0.0, model);
    for (int i = 0; i < 600; ++i) {
        const MotionSegment segment = segmentOf(0.5, 0.3, 0.1 * std::cos(0.8 * i));
        hypothesis.move(segment, model);
        hypothesis.driveLegAlong(segment, model);
    }
    EXPECT_EQ(hypothesis.mean()[HeadingHypothesis::kScale], 0.0);
}

TEST(HeadingHypothesis, TurnsTowardsTheCorridorThatItDrives) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({}, 0.001, 0.0, model);
    hypothesis.loosen(radFromDeg(10.0));
    hypothesis.move(segmentOf(0.5, 0.0, radFromDeg(6.0)), model);
    hypothesis.beginLegAlong(0.0, model);
    for (int i = 0; i < 100; ++i) {
        const MotionSegment segment = segmentOf(0.5, 0.3, 0.0);
        hypothesis.move(segment, model);
        hypothesis.driveLegAlong(segment, model);
    }
    EXPECT_NEAR(degFromRad(hypothesis.heading_rad()), 0.0, 0.5);
}

// 30 m of a way along no corridor, which bends by 15°: how much of it is taken for a drift.
double straightenedDeg(double wander_rad_sqrtm) {
    const DrivingModel model;
    HeadingHypothesis hypothesis({}, 0.001, 0.0, model);
    for (int i = 0; i < 20; ++i) hypothesis.standStill(segmentOf(0.5, 0.0, 0.0), model);
    hypothesis.beginFreeLeg(model);
    for (int i = 0; i < 100; ++i) {
        const MotionSegment segment = segmentOf(0.5, 0.3, radFromDeg(0.15));
        hypothesis.move(segment, model);
        hypothesis.driveFreeLeg(segment, wander_rad_sqrtm, model);
    }
    return 15.0 - degFromRad(hypothesis.heading_rad());
}

TEST(HeadingHypothesis, LetsAWayOffTheCorridorsBend) {
    EXPECT_GT(straightenedDeg(0.0), 5.0);
    EXPECT_LT(straightenedDeg(DrivingModel{}.bend_rad_sqrtm), 1.0);
}

TEST(HeadingHypothesis, KeepsMeanAndSpreadWhenTwoAreMerged) {
    const DrivingModel model;
    HeadingHypothesis left({{}, 0.1}, 0.01, 0.0, model);
    const HeadingHypothesis right({{}, -0.1}, 0.01, 0.0, model);
    left.absorb(right, 0.75);
    EXPECT_NEAR(left.heading_rad(), 0.05, 1e-12);
    EXPECT_NEAR(left.covariance()(2, 2), 0.75 * 0.25 * 0.04, 1e-12);
}

}  // namespace
}  // namespace hedr
