#include "core/track/evaluation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// A drive along a quarter circle of 10 m radius at 1 m/s, 10 Hz.
std::vector<TrackPoint> quarterCircle() {
    std::vector<TrackPoint> track;
    for (int i = 0; i <= 150; ++i) {
        const double t = 0.1 * i;
        const double angle = 0.1 * t;
        track.push_back({t, {{10.0 * std::sin(angle), 10.0 - 10.0 * std::cos(angle)}, angle}, 0.0});
    }
    return track;
}

std::vector<TrackPoint> moved(const std::vector<TrackPoint>& track, const Pose<World>& by) {
    const auto transform = rigidTransform<World, World>(by);
    std::vector<TrackPoint> result = track;
    for (TrackPoint& point : result) {
        point.pose.position = transform * point.pose.position;
        point.pose.heading_rad += by.heading_rad;
    }
    return result;
}

std::vector<TrackPoint> withoutHeadings(std::vector<TrackPoint> track) {
    for (TrackPoint& point : track)
        point.pose.heading_rad = std::numeric_limits<double>::quiet_NaN();
    return track;
}

TEST(Evaluation, OfATrackAgainstItselfIsZero) {
    const auto track = quarterCircle();
    const auto result = evaluate(track, track, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->samples, track.size());
    EXPECT_NEAR(result->duration_s, 15.0, 1e-9);
    EXPECT_NEAR(result->distance_m, 15.0, 1e-3);
    EXPECT_EQ(result->ape_max_m, 0.0);
    EXPECT_EQ(result->heading_max_deg, 0.0);
    EXPECT_NEAR(result->return_position_error_m, 20.0 * std::sin(0.75), 1e-9);
    EXPECT_NEAR(result->return_position_error_percent,
                100.0 * result->return_position_error_m / result->distance_m, 1e-9);
}

TEST(Evaluation, WithoutAlignmentCountsAShiftInFull) {
    const auto truth = quarterCircle();
    const auto result = evaluate(moved(truth, {{3.0, 4.0}, 0.0}), truth, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->ape_rmse_m, 5.0, 1e-9);
    EXPECT_NEAR(result->ape_mean_m, 5.0, 1e-9);
    EXPECT_NEAR(result->ape_median_m, 5.0, 1e-9);
    EXPECT_NEAR(result->end_position_error_m, 5.0, 1e-9);
}

RC_GTEST_PROP(Evaluation, AlignedDoesNotSeeWhereTheEstimateStarted, ()) {
    const auto truth = quarterCircle();
    const Pose<World> by{
        {*rc::gen::inRange(-1000, 1000) * 0.1, *rc::gen::inRange(-1000, 1000) * 0.1},
        *rc::gen::inRange(-314, 314) * 0.01};
    const auto alignment = *rc::gen::element(Alignment::kStart, Alignment::kRigid);
    const auto result = evaluate(moved(truth, by), truth, alignment);
    RC_ASSERT(result.has_value());
    RC_ASSERT(result->ape_max_m < 1e-9);
    RC_ASSERT(result->heading_max_deg < 1e-9);
}

RC_GTEST_PROP(Evaluation, RigidAlignmentIsNeverWorseThanAnother, ()) {
    const auto truth = quarterCircle();
    auto estimate = truth;
    for (TrackPoint& point : estimate) {
        point.pose.position.x += *rc::gen::inRange(-100, 100) * 0.01;
        point.pose.position.y += *rc::gen::inRange(-100, 100) * 0.01;
    }
    const auto rigid = evaluate(estimate, truth, Alignment::kRigid);
    const auto start = evaluate(estimate, truth, Alignment::kStart);
    const auto none = evaluate(estimate, truth, Alignment::kNone);
    RC_ASSERT(rigid->ape_rmse_m <= start->ape_rmse_m + 1e-12);
    RC_ASSERT(rigid->ape_rmse_m <= none->ape_rmse_m + 1e-12);
}

TEST(Evaluation, TakesTheFirstMetresWhereTheTruthHasNoHeading) {
    const auto truth = quarterCircle();
    const auto result =
        evaluate(moved(truth, {{5.0, -7.0}, 2.0}), withoutHeadings(truth), Alignment::kStart);
    ASSERT_TRUE(result);
    EXPECT_LT(result->ape_max_m, 1e-9);
    EXPECT_TRUE(std::isnan(result->heading_rmse_deg));
    EXPECT_TRUE(std::isnan(result->heading_max_deg));
    EXPECT_TRUE(std::isnan(result->end_heading_error_deg));
}

// The first fixes lie a metre to the left: two metres of path would turn the track by tens of
// degrees.
TEST(Evaluation, AMetreOfNoiseInTheFirstFixesHardlyTurnsALongRun) {
    std::vector<TrackPoint> straight;
    for (int i = 0; i <= 400; ++i) straight.push_back({0.5 * i, {{0.5 * i, 0.0}, 0.0}});
    auto fixes = withoutHeadings(straight);
    for (int i = 1; i < 8; ++i) fixes[static_cast<std::size_t>(i)].pose.position.y = 1.0;
    const auto result = evaluate(straight, fixes, Alignment::kStart);
    ASSERT_TRUE(result);
    EXPECT_LT(result->end_position_error_m, 200.0 * std::sin(radFromDeg(0.5)));
}

// The fixes of a minute of standing make a path of a hundred metres.
TEST(Evaluation, IsNotMisledByTheNoiseOfAStandingStart) {
    std::vector<TrackPoint> driven;
    std::vector<TrackPoint> fixes;
    for (int i = 0; i <= 600; ++i) {
        const double x = std::max(0.0, 0.5 * (i - 120));
        driven.push_back({0.5 * i, {{x, 0.0}, 0.0}});
        fixes.push_back({0.5 * i, {{std::sin(2.4 * i), x + std::cos(1.7 * i)}, 0.0}});
    }
    const auto result = evaluate(driven, withoutHeadings(fixes), Alignment::kStart);
    ASSERT_TRUE(result);
    EXPECT_LT(result->ape_rmse_m, 5.0);
}

TEST(Evaluation, GoesOnBehindATimeThatIsThereTwice) {
    const auto truth = quarterCircle();
    auto estimate = truth;
    estimate.insert(estimate.begin() + 10, estimate[10]);
    const auto result = evaluate(estimate, truth, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->samples, truth.size());
    EXPECT_EQ(result->ape_max_m, 0.0);
}

TEST(Evaluation, FollowsAHeadingErrorOverMoreThanAHalfTurn) {
    const auto truth = quarterCircle();
    auto estimate = truth;
    // 250 degrees of drift, in headings that are wrapped as many a tool writes them.
    for (std::size_t i = 0; i < estimate.size(); ++i) {
        double& heading = estimate[i].pose.heading_rad;
        heading = wrapAngle(heading - radFromDeg(250.0) * static_cast<double>(i) / 150.0);
    }
    const auto result = evaluate(estimate, truth, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->end_heading_error_deg, -250.0, 1e-9);
    EXPECT_NEAR(result->heading_max_deg, 250.0, 1e-9);
}

TEST(Evaluation, MatchesNoEstimateTwice) {
    const auto truth = quarterCircle();  // 10 Hz
    std::vector<TrackPoint> estimate;    // 1 Hz
    for (std::size_t i = 0; i < truth.size(); i += 10) estimate.push_back(truth[i]);
    const auto result = evaluate(estimate, truth, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->samples, estimate.size());
    EXPECT_EQ(result->ape_max_m, 0.0);
}

TEST(Evaluation, LeavesOutWhatHasNoPartnerInTime) {
    const auto truth = quarterCircle();
    auto estimate = truth;
    estimate.erase(estimate.begin() + 50, estimate.begin() + 100);
    const auto result = evaluate(estimate, truth, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->samples, truth.size() - 50);
}

TEST(Evaluation, FailsWhereNothingMatchesInTime) {
    const auto truth = quarterCircle();
    auto estimate = truth;
    for (TrackPoint& point : estimate) point.t_s += 1000.0;
    EXPECT_EQ(evaluate(estimate, truth, Alignment::kStart).error().code, ErrorCode::kNoData);
    EXPECT_EQ(evaluate({}, truth, Alignment::kStart).error().code, ErrorCode::kNoData);
    EXPECT_EQ(evaluate(truth, {}, Alignment::kStart).error().code, ErrorCode::kNoData);
}

TEST(Evaluation, OfOnePoseWorks) {
    const std::vector<TrackPoint> pose = {{1.0, {{2.0, 3.0}, 0.5}, 0.0}};
    const auto result = evaluate(pose, pose, Alignment::kRigid);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->samples, 1U);
    EXPECT_EQ(result->ape_rmse_m, 0.0);
    EXPECT_TRUE(std::isnan(result->return_position_error_percent));
}

TEST(Evaluation, BearsTimesOutOfOrder) {
    const auto truth = quarterCircle();
    auto estimate = truth;
    std::swap(estimate[20], estimate[40]);
    const auto result = evaluate(estimate, truth, Alignment::kNone);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->ape_max_m, 0.0);
}

}  // namespace
}  // namespace hedr
