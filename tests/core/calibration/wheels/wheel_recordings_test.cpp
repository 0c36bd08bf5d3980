// The wheels of real robots, from what they were driven.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/calibration/wheels/wheel_drive.h"
#include "core/fusion/tracker.h"
#include "core/robot/sensor_csv.h"
#include "core/track/evaluation.h"
#include "core/track/track_file.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

struct Recording {
    std::vector<SensorReport> reports{};
    std::vector<TrackPoint> truth{};
    Vehicle vehicle{};
};

// None where it is absent.
std::optional<Recording> recordingOf(const std::string& name, const char* truth) {
    const auto folder = kRecordings / name;
    auto log = loadSensorLog(folder / "sensors.csv");
    auto track = loadTrack(folder / truth);
    auto vehicle = loadVehicle(folder / "vehicle.toml");
    if (!log || !track || !vehicle) return std::nullopt;
    return Recording{std::move(log->reports), std::move(*track), std::move(*vehicle)};
}

// Of the wheels alone against the truth of that time, rms.
double positionError_m(const Recording& recording, double from_s, const Vehicle& vehicle) {
    Tracker tracker({.vehicle = vehicle, .estimators = {findEstimator("odometry")}});
    std::vector<TrackPoint> track;
    for (const SensorReport& report : recording.reports) {
        if (report.robot_time_s >= from_s && tracker.add(report)) track.push_back(tracker.point(0));
    }
    // The tracker's time begins at nought.
    const double begin_s = std::ranges::find_if(recording.reports, [from_s](const auto& report) {
                               return report.robot_time_s >= from_s;
                           })->robot_time_s;
    std::vector<TrackPoint> truth;
    for (TrackPoint point : recording.truth) {
        if (point.t_s >= begin_s) truth.push_back(point);
    }
    const bool same_clock = !track.empty() && track.front().t_s >= begin_s;
    for (TrackPoint& point : track) point.t_s += same_clock ? 0.0 : begin_s;
    const auto evaluation = evaluate(track, truth, Alignment::kStart);
    EXPECT_TRUE(evaluation);
    return evaluation ? evaluation->ape_rmse_m : 0.0;
}

SampleSet partOf(const Recording& recording, double until_s) {
    SampleSet set{"recording"};
    for (const SensorReport& report : recording.reports) {
        if (report.robot_time_s < until_s) set.reports.push_back(report);
    }
    return set;
}

class WheelsOfRealRobots : public testing::TestWithParam<const char*> {};

// The first three fifths find them, the rest judges: accepted are only wheels that lower its error.
TEST_P(WheelsOfRealRobots, LowerTheErrorOfTheRestOrAreNotAccepted) {
    const auto recording = recordingOf(GetParam(), "truth.csv");
    if (!recording) GTEST_SKIP() << "The recording is absent.";
    const double half_s = recording->reports.front().robot_time_s * 0.4 +
                          recording->reports.back().robot_time_s * 0.6;
    const std::vector sets{partOf(*recording, half_s)};
    const WheelDrive found = calibrateByDriving(sets, recording->vehicle);
    const Vehicle now = calibrated(recording->vehicle, found.calibration).value();
    const double before_m = positionError_m(*recording, half_s, recording->vehicle);
    const double after_m = positionError_m(*recording, half_s, now);
    std::printf("wheelbase %.4f, found %.4f +- %.4f m, right larger by %.4f +- %.4f; %s\n",
                recording->vehicle.geometry.wheelbase_m, found.fit.wheelbase_m.value,
                found.fit.wheelbase_m.standard_error, found.fit.right_larger.value,
                found.fit.right_larger.standard_error, found.calibration.reason.c_str());
    std::printf("position error of the rest: %.3f m, now %.3f m\n", before_m, after_m);
    if (found.calibration.verdict == Verdict::kAccepted) {
        EXPECT_LT(after_m, before_m);
    } else {
        EXPECT_EQ(after_m, before_m);
        EXPECT_FALSE(found.calibration.reason.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Recordings, WheelsOfRealRobots,
                         testing::Values("maebot_convex", "maebot_pentagon", "mbot_square"),
                         [](const auto& name) { return std::string(name.param); });

constexpr const char* kReference = "reference_not_truth.csv";  // made with its gyro

TEST(WheelsOfASkidSteeredRobot, AreForTheGyroToTellAndLowerTheErrorOfAnotherDrive) {
    const auto first = recordingOf("penn_corridor_20_notruth", kReference);
    const auto second = recordingOf("penn_corridor_21_notruth", kReference);
    const auto other = recordingOf("penn_corridor_23_notruth", kReference);
    if (!first || !second || !other) GTEST_SKIP() << "The recordings are absent.";
    const std::vector sets{partOf(*first, 1e9), partOf(*second, 1e9)};
    const WheelDrive unsure = calibrateByDriving(sets, first->vehicle);
    EXPECT_EQ(unsure.calibration.verdict, Verdict::kNotProven) << unsure.calibration.reason;
    EXPECT_NE(unsure.calibration.reason.find("scale of the gyro"), std::string::npos);

    Vehicle vehicle = first->vehicle;
    vehicle.gyro_scale = 1.0001;  // as if it were calibrated
    const WheelDrive sure = calibrateByDriving(sets, vehicle);
    EXPECT_EQ(sure.calibration.verdict, Verdict::kAccepted) << sure.calibration.reason;
    const Vehicle now = calibrated(vehicle, sure.calibration).value();
    const double before_m = positionError_m(*other, 0.0, vehicle);
    const double after_m = positionError_m(*other, 0.0, now);
    std::printf("wheelbase %.3f +- %.3f m; error of the third drive %.2f m, now %.2f m\n",
                sure.fit.wheelbase_m.value, sure.fit.wheelbase_m.standard_error, before_m, after_m);
    EXPECT_LT(after_m, 0.8 * before_m);
}

}  // namespace
}  // namespace hedr
