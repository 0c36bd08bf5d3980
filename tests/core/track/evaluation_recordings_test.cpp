#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "core/robot/sensor_csv.h"
#include "core/track/evaluation.h"
#include "core/track/track_file.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

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
