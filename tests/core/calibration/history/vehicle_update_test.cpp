#include "core/calibration/history/vehicle_update.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/robot/vehicle_edit.h"
#include "core/text/text_file.h"
#include "tests/core/calibration/history/history_examples.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

using test::fullRecord;
using test::someReports;

class VehicleUpdate : public test::VehicleWithHistory {};

TEST_F(VehicleUpdate, GivesTheVehicleFileWhatWasAccepted) {
    Calibration calibration{.procedure = "bias",
                            .found = {{"gyro_bias_rad_s", std::nullopt, {0.002, 1e-5, 20.0}}},
                            .verdict = Verdict::kAccepted};
    const std::vector<SampleSet> samples{
        {"log", {{.temperature_c = 20.0}, {.temperature_c = 22.0}}}};
    const auto kept = keepInHistory(
        vehicle_, calibration, {.sets = samples, .settings = {.turns = 3.0}}, {.time_utc = "now"});
    ASSERT_TRUE(kept && kept->taken_over);
    EXPECT_EQ(loadVehicle(vehicle_)->gyro_bias_rad_s, 0.002);
    const auto record = historyEntry(history_, kept->entry)->record;
    EXPECT_EQ(record->vehicle_before, text_);
    EXPECT_EQ(record->temperature_c, 21.0);
    EXPECT_EQ(record->told.turns, 3.0);
}

TEST_F(VehicleUpdate, KeepsARefusedCalibrationAndLeavesTheVehicleFile) {
    Calibration calibration{.procedure = "bias",
                            .found = {{"gyro_bias_rad_s", std::nullopt, {0.002, 1e-5, 20.0}}},
                            .verdict = Verdict::kRefused};
    const auto kept = keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"});
    ASSERT_TRUE(kept);
    EXPECT_FALSE(kept->taken_over);
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
    EXPECT_EQ(historyEntry(history_, kept->entry)->record->verdict, Verdict::kRefused);
}

TEST_F(VehicleUpdate, KeepsWhatIsNotWantedAndLeavesTheVehicleFile) {
    const Calibration calibration{.procedure = "bias",
                                  .found = {{"gyro_bias_rad_s", std::nullopt, {0.002, 1e-5, 20.0}}},
                                  .verdict = Verdict::kAccepted};
    const auto kept =
        keepInHistory(vehicle_, calibration, {}, {.time_utc = "now", .declined = true});
    ASSERT_TRUE(kept);
    EXPECT_FALSE(kept->taken_over);
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
    EXPECT_FALSE(historyEntry(history_, kept->entry)->record->taken_over);
}

// A wheelbase that was found beside other diameters would turn the robot by another angle.
TEST_F(VehicleUpdate, PutsNoWheelsBesideOthersThanTheyWereFoundWith) {
    const Calibration calibration{.procedure = "wheels",
                                  .found = {{"wheelbase_m", 0.4, {0.5, 0.001}}},
                                  .verdict = Verdict::kAccepted};
    Vehicle other;
    other.geometry.left_wheel_diameter_m *= 1.1;
    std::ofstream(vehicle_) << formatVehicle(other);
    const auto kept = keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"});
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, ErrorCode::kOtherWheels);
    EXPECT_EQ(loadVehicle(vehicle_).value(), other);
    const auto entries = loadHistory(history_);
    ASSERT_EQ(entries->size(), 1U);
    EXPECT_NE(kept.error().detail.find(entries->front().name), std::string::npos);
    EXPECT_FALSE(entries->front().record->taken_over);
    Calibration gyro = calibration;
    gyro.found = {{"gyro_scale", 1.0, {1.02, 0.001}}};
    EXPECT_TRUE(keepInHistory(vehicle_, gyro, {}, {.time_utc = "now"})) << "goes with any wheels";
}

TEST_F(VehicleUpdate, MakesAVehicleFileThatIsNotThereYet) {
    const fs::path fresh = folder_.path() / "fresh.toml";
    Calibration calibration{.procedure = "wheels",
                            .found = {{"wheelbase_m", 0.4, {0.5, 0.001}}},
                            .verdict = Verdict::kAccepted};
    ASSERT_TRUE(keepInHistory(fresh, calibration, {}, {.time_utc = "now"}));
    EXPECT_EQ(loadVehicle(fresh)->geometry.wheelbase_m, 0.5);
}

// Somebody else may have changed it since the samples were read.
TEST_F(VehicleUpdate, ChangesNothingButWhatWasFound) {
    const Calibration calibration{.procedure = "wheels",
                                  .found = {{"wheelbase_m", 0.4, {0.5, 0.001}}},
                                  .verdict = Verdict::kAccepted};
    Vehicle meanwhile;
    meanwhile.gyro_bias_rad_s = 0.003;
    std::ofstream(vehicle_) << "# limited\n" << formatVehicle(meanwhile);
    ASSERT_TRUE(keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"}));
    EXPECT_EQ(loadVehicle(vehicle_)->gyro_bias_rad_s, 0.003);
    EXPECT_EQ(loadVehicle(vehicle_)->geometry.wheelbase_m, 0.5);
    EXPECT_TRUE(readTextFile(vehicle_)->starts_with("# limited\n"));
}

TEST_F(VehicleUpdate, WritesNothingThatItCouldNotReadAgain) {
    Calibration calibration{.procedure = "wheels",
                            .found = {{"wheelbase_m", 0.4, {0.5, 0.001}}},
                            .verdict = Verdict::kAccepted};
    std::ofstream(vehicle_) << "# R\xe4"
                               "der\n"
                            << text_;
    const std::string before = readTextFile(vehicle_).value();
    EXPECT_EQ(keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"}).error().code,
              ErrorCode::kBadFormat);
    EXPECT_EQ(readTextFile(vehicle_).value(), before);
    std::ofstream(vehicle_) << text_;
    EXPECT_FALSE(keepInHistory(vehicle_, calibration, {.settings = {.distance_m = std::nan("")}},
                               {.time_utc = "now"}));
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
    const auto kept = keepInHistory(vehicle_, calibration, {.sets = {{"l\xf6g", someReports()}}},
                                    {.time_utc = "now", .who = "J\xf6rg", .surface = " caf\xe9\n"});
    ASSERT_TRUE(kept);
    EXPECT_EQ(historyEntry(history_, kept->entry)->record->surface, "caf\uFFFD");
    EXPECT_EQ(loadHistory(history_)->size(), 1U);
}

TEST_F(VehicleUpdate, SaysThatTheVehicleFileCouldNotTakeIt) {
    fs::remove(vehicle_);
    fs::create_directory(vehicle_);
    const Calibration calibration{.procedure = "wheels",
                                  .found = {{"wheelbase_m", 0.4, {0.5, 0.001}}},
                                  .verdict = Verdict::kAccepted};
    EXPECT_FALSE(keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"}));
    fs::remove(vehicle_);
    const fs::path nowhere = folder_.path() / "none" / "v.toml";
    std::ofstream(folder_.path() / "none") << "a file where the folder should be";
    EXPECT_FALSE(keepInHistory(nowhere, calibration, {}, {.time_utc = "now"}));
}

TEST_F(VehicleUpdate, TakesWhatSeveralProgramsFindAtOnce) {
    const std::array<std::string_view, 4> keys{"wheelbase_m", "gyro_bias_rad_s", "gyro_scale",
                                               "gyro_noise_rad_s_sqrthz"};
    std::vector<std::jthread> programs;
    for (const std::string_view key : keys) {
        programs.emplace_back([this, key] {
            const Calibration calibration{.procedure = "test",
                                          .found = {{key, {}, {0.7, 0.1}}},
                                          .verdict = Verdict::kAccepted};
            EXPECT_TRUE(keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"}));
        });
    }
    programs.clear();
    const Vehicle vehicle = loadVehicle(vehicle_).value();
    for (const std::string_view key : keys) EXPECT_EQ(vehicleNumber(vehicle, key), 0.7) << key;
    const auto entries = loadHistory(history_);
    for (const HistoryEntry& entry : *entries) {
        EXPECT_TRUE(entry.record->taken_over);
        EXPECT_NE(entry.record->vehicle_after, entry.record->vehicle_before);
        EXPECT_EQ(std::distance(fs::directory_iterator(entry.folder), {}), 1);
    }
}

TEST_F(VehicleUpdate, RestoresTheVehicleFileAndKeepsWhatItReplaces) {
    Vehicle changed;
    changed.geometry.wheelbase_m = 0.5;
    CalibrationRecord record = fullRecord();
    record.vehicle_before = text_;
    record.vehicle_after = formatVehicle(changed);
    const auto name = keepCalibration(history_, record, {});
    const auto entry = historyEntry(history_, *name);
    ASSERT_TRUE(restoreVehicle(vehicle_, *entry, RestoreTo::kAfter, "2026-11-29T00:00:00Z", "me"));
    EXPECT_EQ(loadVehicle(vehicle_).value(), changed);
    const auto restored = historyEntry(history_, "restore");
    EXPECT_EQ(restored->record->vehicle_before, text_);
    ASSERT_TRUE(
        restoreVehicle(vehicle_, *restored, RestoreTo::kBefore, "2026-11-30T00:00:00Z", ""));
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
}

TEST_F(VehicleUpdate, RestoresAVehicleFileThatIsGone) {
    CalibrationRecord record = fullRecord();
    record.vehicle_after = text_;
    const auto name = keepCalibration(history_, record, {});
    ASSERT_TRUE(name);
    fs::remove(vehicle_);
    const auto entry = historyEntry(history_, *name);
    ASSERT_TRUE(restoreVehicle(vehicle_, *entry, RestoreTo::kAfter, "now", ""));
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
}

}  // namespace
}  // namespace hedr
