#include "radio/recomputation.h"

#include <gtest/gtest.h>

#include "core/mission/mission_writer.h"
#include "tests/core/text/scratch_folder.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

class Recomputation : public ::testing::Test {
  protected:
    Recomputation() {
        std::vector<SensorReport> reports = straightDrive(20.0);
        for (std::size_t i = 0; i < reports.size(); i += 10)
            reports[i].magnetic_field = {0.5, 0.1, 0.2};
        auto mission = MissionWriter::create(file_, {});
        EXPECT_TRUE(mission && mission->writeVehicle(spokenVehicle()) &&
                    mission->writeBytes(0.0, spoken(reports)) && mission->commit());
    }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_.path() / "drive.hedr";
};

TEST_F(Recomputation, NamesTheVehiclesKeysThatAnEstimatorNeeds) {
    for (const auto& [estimator, key] :
         {std::pair{"gyro_kalman", "gyro_drift_time_s"}, std::pair{"gh_combined", "mag_range_x"}}) {
        const auto track = recomputeTrack(file_, estimator, {});
        ASSERT_FALSE(track) << estimator;
        EXPECT_EQ(track.error().code, ErrorCode::kMissingKey) << estimator;
        EXPECT_NE(track.error().detail.find(key), std::string::npos) << track.error().detail;
    }
}

TEST_F(Recomputation, RunsWhatAnotherVehicleFileAllows) {
    Vehicle vehicle = spokenVehicle();
    vehicle.gyro_drift = {0.0, 0.001, 300.0};
    vehicle.magnetometer = {0.0, 0.0, 500.0, 500.0};
    for (const char* estimator : {"gyro_kalman", "gh_magnetometer", "gh_combined"}) {
        const auto track = recomputeTrack(file_, estimator, {.vehicle = vehicle});
        ASSERT_TRUE(track) << estimator;
        EXPECT_NEAR(track->points.back().pose.position.x, 9.0, 0.05) << estimator;
    }
}

TEST_F(Recomputation, TellsTheDirectionWhereItWasTold) {
    const std::vector<std::uint8_t> bytes = spoken(straightDrive(60.0));
    const auto file = folder_.path() / "told.hedr";
    auto mission = MissionWriter::create(file, {});
    const auto half = std::span(bytes).first(bytes.size() / 2);
    const double direction_rad = radFromDeg(3.0);
    ASSERT_TRUE(
        mission && mission->writeVehicle(spokenVehicle()) && mission->writeBytes(0.0, half) &&
        mission->writeStreamMark(30.0, StreamKind::kDirection, packDirection(direction_rad)) &&
        mission->writeBytes(30.0, std::span(bytes).subspan(half.size())) && mission->commit());
    Receiver live({.vehicle = spokenVehicle()});
    live.feed(half);
    live.setDirection(direction_rad);
    live.feed(std::span(bytes).subspan(half.size()));
    for (const NamedPoints& track : live.takePoints()) {
        const auto again = recomputeTrack(file, track.name, {});
        ASSERT_TRUE(again) << track.name;
        ASSERT_EQ(again->points.size(), track.points.size()) << track.name;
        const bool told = track.name.starts_with("hedr");
        for (std::size_t i = 0; i < track.points.size(); ++i)
            ASSERT_EQ(again->points[i].pose, track.points[i].pose) << track.name << ' ' << i;
        EXPECT_NEAR(degFromRad(track.points.back().pose.heading_rad), told ? 3.0 : 0.0, 1.0)
            << track.name;
    }
    const auto overruled = recomputeTrack(file, "hedr", {.settings = {"direction_deg=auto"}});
    ASSERT_TRUE(overruled);
    EXPECT_NEAR(degFromRad(overruled->points.back().pose.heading_rad), 0.0, 1.0);
}

TEST_F(Recomputation, SaysThatAMissionHasNoSuchSensor) {
    auto mission = MissionWriter::create(folder_.path() / "blind.hedr", {});
    std::vector<SensorReport> reports = straightDrive(5.0);
    for (SensorReport& report : reports) report.gyro = {};
    ASSERT_TRUE(mission && mission->writeBytes(0.0, spoken(reports)) && mission->commit());
    const auto track = recomputeTrack(folder_.path() / "blind.hedr", "gyro", {});
    ASSERT_FALSE(track);
    EXPECT_EQ(track.error().code, ErrorCode::kNoData);
    EXPECT_EQ(track.error().detail, "it has no gyro (gyro_z_rad_s), which gyro needs");
    const auto all = recomputeTracks(folder_.path() / "blind.hedr", {});
    ASSERT_TRUE(all);
    EXPECT_TRUE(all->given.both_wheels);
    EXPECT_FALSE(all->given.gyro || all->given.magnetometer);
}

TEST_F(Recomputation, GivesTheSensorsOfAMissionWithTimesThatGoOn) {
    const auto sensors = sensorsIn(file_);
    ASSERT_TRUE(sensors);
    ASSERT_EQ(sensors->stretches.size(), 1U);
    const std::vector<SensorReport>& reports = sensors->stretches.front().reports;
    EXPECT_GT(reports.size(), 0.9 * static_cast<double>(straightDrive(20.0).size()));
    EXPECT_EQ(sensors->vehicle.geometry, spokenVehicle().geometry);
    for (std::size_t i = 1; i < reports.size(); ++i)
        EXPECT_GT(reports[i].robot_time_s, reports[i - 1].robot_time_s);
}

TEST_F(Recomputation, SaysThatAMissionHasNoSensors) {
    const auto file = folder_.path() / "none.hedr";
    auto mission = MissionWriter::create(file, {});
    ASSERT_TRUE(mission && mission->commit());
    const auto sensors = sensorsIn(file);
    ASSERT_FALSE(sensors);
    EXPECT_EQ(sensors.error().code, ErrorCode::kNoData);
}

}  // namespace
}  // namespace hedr
