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

}  // namespace
}  // namespace hedr
