#include "core/track/evaluation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/geometry/angle.h"
#include "core/robot/sensor_csv.h"
#include "core/track/track_file.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

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

// The figures of the recordings' own README files, made by another program.
struct PublishedFigure {
    const char* recording;
    double rmse_m;
    double end_heading_error_deg;
};

// The pose that the robot itself computed.
std::vector<TrackPoint> recordedOdometry(const std::filesystem::path& folder) {
    const auto log = loadSensorLog(folder / "sensors.csv").value();
    std::vector<TrackPoint> odometry;
    for (const SensorReport& report : log.reports) {
        const auto& pose = std::get<OdometryPose>(report.odometry);
        odometry.push_back({report.robot_time_s, {{pose.x_m, pose.y_m}, pose.heading_rad}, 0.0});
    }
    return odometry;
}

class RecordedOdometry : public testing::TestWithParam<PublishedFigure> {};

TEST_P(RecordedOdometry, GivesThePublishedFigure) {
    const auto folder = kRecordings / GetParam().recording;
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const auto truth = loadTrack(folder / "truth.csv");
    ASSERT_TRUE(truth);
    const auto result = evaluate(recordedOdometry(folder), *truth, Alignment::kStart);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->ape_rmse_m, GetParam().rmse_m, 0.02 * GetParam().rmse_m);
    EXPECT_NEAR(result->end_heading_error_deg, GetParam().end_heading_error_deg, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Evaluation, RecordedOdometry,
                         testing::Values(PublishedFigure{"tuc_corridor", 82.935, -250.35},
                                         PublishedFigure{"wean_1", 2.040, 26.26},
                                         PublishedFigure{"plaza2_outdoor", 58.592, -125.97}),
                         [](const auto& figure) { return std::string(figure.param.recording); });

// Its truth has no heading and is off by metres; its README says 14.90 m rms and 17.90 m at the
// end.
TEST(Evaluation, OfTheOpenGroundGivesThePublishedFigure) {
    const auto folder = kRecordings / "husky_outdoor";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const auto truth = loadTrack(folder / "truth.csv");
    ASSERT_TRUE(truth);
    const auto result = evaluate(recordedOdometry(folder), *truth, Alignment::kStart);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->ape_rmse_m, 14.897, 0.03 * 14.897);
    EXPECT_NEAR(result->end_position_error_m, 17.898, 0.03 * 17.898);
}

// Its truth has no heading; its README says 0.252 m rms and 0.419 m at the end.
TEST(Evaluation, OfTheLabyrinthGivesThePublishedFigure) {
    const auto folder = kRecordings / "tuc_labyrinth";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const auto log = loadSensorLog(folder / "sensors.csv");
    const auto truth = loadTrack(folder / "truth.csv");
    ASSERT_TRUE(log);
    ASSERT_TRUE(truth);
    std::vector<TrackPoint> odometry;
    Pose<World> pose;
    WheelTravel before;
    for (const SensorReport& report : log->reports) {
        const auto& travel = std::get<WheelTravel>(report.odometry);
        const double left_m = travel.left_m - before.left_m;
        const double right_m = travel.right_m - before.right_m;
        const double turn_rad = (right_m - left_m) / 0.155;
        const double middle_rad = pose.heading_rad + 0.5 * turn_rad;
        pose.position =
            pose.position +
            0.5 * (left_m + right_m) * Vector<World>{std::cos(middle_rad), std::sin(middle_rad)};
        pose.heading_rad += turn_rad;
        before = travel;
        odometry.push_back({report.robot_time_s, pose, 0.0});
    }
    const auto result = evaluate(odometry, *truth, Alignment::kStart);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->ape_rmse_m, 0.252, 0.001);
    EXPECT_NEAR(result->end_position_error_m, 0.419, 0.001);
}

struct EvoCase {
    const char* command;
    Alignment alignment;
    bool heading;  // its figures are of the heading in degrees, not of the position
};

void PrintTo(const EvoCase& evo, std::ostream* out) { *out << evo.command; }

class EvoFigures : public testing::TestWithParam<EvoCase> {};

// shared/data/evo: two tracks, and what evo 1.36.5 says of them.
TEST_P(EvoFigures, AreOursToNineDigits) {
    const auto folder = kRecordings / "evo";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const auto estimate = loadTrack(folder / "est.tum");
    const auto truth = loadTrack(folder / "ref.tum");
    ASSERT_TRUE(estimate && truth);
    std::ifstream file(folder / "expected.json");
    const auto expected = nlohmann::json::parse(file);
    nlohmann::json stats;
    for (const auto& each : expected.at("cases")) {
        if (each.at("cmd") == GetParam().command) stats = each.at("stats");
    }
    ASSERT_FALSE(stats.is_null());
    const auto ours = evaluate(*estimate, *truth, GetParam().alignment);
    ASSERT_TRUE(ours);
    const auto expectFigure = [&](const char* name, double value) {
        EXPECT_NEAR(value, stats.at(name).get<double>(), 1e-9) << name;
    };
    if (GetParam().heading) {
        expectFigure("rmse", ours->heading_rmse_deg);
        expectFigure("max", ours->heading_max_deg);
        return;
    }
    expectFigure("rmse", ours->ape_rmse_m);
    expectFigure("mean", ours->ape_mean_m);
    expectFigure("median", ours->ape_median_m);
    expectFigure("max", ours->ape_max_m);
}

INSTANTIATE_TEST_SUITE_P(
    Evaluation, EvoFigures,
    testing::Values(EvoCase{"evo_ape tum ref.tum est.tum", Alignment::kNone, false},
                    EvoCase{"evo_ape tum ref.tum est.tum --align_origin", Alignment::kStart, false},
                    EvoCase{"evo_ape tum ref.tum est.tum -a", Alignment::kRigid, false},
                    EvoCase{"evo_ape tum ref.tum est.tum -r angle_deg", Alignment::kNone, true},
                    EvoCase{"evo_ape tum ref.tum est.tum -a -r angle_deg", Alignment::kRigid,
                            true}));

}  // namespace
}  // namespace hedr
