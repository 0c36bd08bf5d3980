#include "core/calibration/history/vehicle_history.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/robot/sensor_csv.h"
#include "core/text/text_file.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

CalibrationRecord fullRecord() {
    CalibrationRecord record{.procedure = "bias",
                             .time_utc = "2026-11-28T12:30:05Z",
                             .who = "Ada \"the\" operator",
                             .robot = "packbot 3",
                             .surface = "concrete",
                             .temperature_c = 21.5,
                             .program_version = "0.1.0",
                             .verdict = Verdict::kAccepted,
                             .reason = "Better.",
                             .taken_over = true,
                             .remarks = {"One.", "It said \"two\"\nand three."},
                             .vehicle_before = "name = \"a\" # old\n",
                             .vehicle_after = "name = \"b\"\n"};
    record.found = {{"gyro_bias_rad_s", 0.001, {0.1 + 0.2, 1e-5, 23.0}},
                    {"wheelbase_m", std::nullopt, {0.4, 0.001}},
                    {"gyro_drift_time_s", std::nullopt, {338.0, 24.0, 97.0, 0.125}}};
    record.told = {.turns = 2.0,
                   .closed = true,
                   .distance_m = 1.0 / 3.0,
                   .on_before_s = 60.0,
                   .room_changes = true,
                   .ends = {{1, {0.12, -0.03}}, {7, {-0.1, 0.2}, Turning::kClockwise}}};
    record.track_widths = {{0.35, {0.41, 0.002, 9.0}, 10}, {0.8, {0.44, 0.003}, 11}};
    record.proof = Proof{"drift", "rad/s", 7, 0.1, 0.01, 10.0, {9.0, 11.0}, {8.0, 12.0}};
    record.raw = {{"samples-1.csv", std::string(64, 'a'), "/logs/a.csv"}};
    return record;
}

std::vector<SensorReport> someReports() {
    std::vector<SensorReport> reports;
    for (int i = 0; i < 5; ++i)
        reports.push_back({.robot_time_s = 0.1 * i,
                           .odometry = WheelTicks{i, 2 * i},
                           .gyro = GyroRate{0.01 * i}});
    return reports;
}

TEST(CalibrationRecord, ComesBackFromItsTextToTheLastBit) {
    const auto again = parseRecord(formatRecord(fullRecord()), "r");
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(*again, fullRecord());
    const CalibrationRecord empty{.procedure = "allan", .time_utc = "now", .robot = "r"};
    EXPECT_EQ(parseRecord(formatRecord(empty), "r").value(), empty);
}

TEST(CalibrationRecord, IsRefusedWithTheLineThatIsWrong) {
    std::string text = formatRecord(fullRecord());
    text.replace(text.find("\"accepted\""), 10, "\"splendid\"");
    const auto read = parseRecord(text, "r.toml");
    ASSERT_FALSE(read);
    EXPECT_TRUE(read.error().subject.starts_with("r.toml:")) << read.error().subject;
    EXPECT_NE(read.error().detail.find("verdict"), std::string::npos);
    EXPECT_FALSE(parseRecord("format = 1\n", "r.toml"));
    EXPECT_FALSE(parseRecord(formatRecord(fullRecord()) + "more = 1\n", "r.toml"));
}

TEST(CalibrationRecord, IsRefusedWhereWhatWasToldCannotHaveBeenTold) {
    for (const auto& [right, wrong] : {std::pair{"run = 7", "run = 0"},
                                       {"direction = \"clockwise\"", "direction = \"left\""},
                                       {"on_before_s = 60.0", "on_before_s = -1.0"},
                                       {"lopsided = 0.125", "lopsided = 1.5"},
                                       {"rate_rad_s = 0.8", "rate = 0.8"}}) {
        std::string text = formatRecord(fullRecord());
        const std::size_t at = text.find(right);
        ASSERT_NE(at, std::string::npos) << right;
        text.replace(at, std::string_view(right).size(), wrong);
        EXPECT_FALSE(parseRecord(text, "r.toml")) << wrong;
    }
}

class VehicleHistory : public testing::Test {
  protected:
    VehicleHistory() { std::ofstream(vehicle_) << text_; }

    ScratchFolder folder_;
    fs::path vehicle_ = folder_.path() / "robot.toml";
    fs::path history_ = historyFolderOf(vehicle_);
    std::string text_ = formatVehicle({});
};

TEST_F(VehicleHistory, KeepsRecordAndSamplesWithTheirHash) {
    const auto name = keepCalibration(history_, fullRecord(), {{"live", someReports()}});
    ASSERT_TRUE(name);
    EXPECT_EQ(*name, "2026-11-28T123005Z-bias");
    const auto entries = loadHistory(history_);
    ASSERT_TRUE(entries && entries->size() == 1 && entries->front().record);
    const RawSamples& raw = entries->front().record->raw.back();
    EXPECT_EQ(raw.origin, "live");
    EXPECT_EQ(loadSensorLog(entries->front().folder / raw.file)->reports, someReports());
}

TEST_F(VehicleHistory, NeverOverwritesAnEntryOfTheSameTime) {
    ASSERT_TRUE(keepCalibration(history_, fullRecord(), {}));
    EXPECT_EQ(keepCalibration(history_, fullRecord(), {}).value(), "2026-11-28T123005Z-bias-2");
    EXPECT_EQ(loadHistory(history_)->size(), 2U);
}

TEST_F(VehicleHistory, ListsADamagedEntryAndPassesOverWhatACrashLeft) {
    const auto name = keepCalibration(history_, fullRecord(), {});
    std::ofstream(history_ / *name / "record.toml") << "format = ";
    fs::create_directories(history_ / "2026-11-28T000000Z-bias");
    const auto entries = loadHistory(history_);
    ASSERT_EQ(entries->size(), 1U);
    EXPECT_FALSE(entries->front().record);
}

TEST_F(VehicleHistory, FindsAnEntryByAPartOfItsName) {
    ASSERT_TRUE(keepCalibration(history_, fullRecord(), {}));
    CalibrationRecord other = fullRecord();
    other.procedure = "umbmark";
    ASSERT_TRUE(keepCalibration(history_, other, {}));
    EXPECT_EQ(historyEntry(history_, "umbmark")->record->procedure, "umbmark");
    EXPECT_EQ(historyEntry(history_, "2026").error().code, ErrorCode::kUnknownName);
    EXPECT_NE(historyEntry(history_, "xyz").error().detail.find("umbmark"), std::string::npos);
}

TEST_F(VehicleHistory, RestoresTheVehicleFileAndKeepsWhatItReplaces) {
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

TEST_F(VehicleHistory, ExportsAnEntryUnlessItsSamplesWereChanged) {
    const auto name = keepCalibration(history_, fullRecord(), {{"live", someReports()}});
    CalibrationRecord good = historyEntry(history_, *name)->record.value();
    good.raw.erase(good.raw.begin());  // a file that never was
    HistoryEntry entry{*name, history_ / *name, good};
    ASSERT_TRUE(exportEntry(entry, folder_.path() / "out"));
    EXPECT_TRUE(fs::exists(folder_.path() / "out" / "samples-1.csv"));
    EXPECT_EQ(exportEntry(entry, folder_.path() / "out").error().code, ErrorCode::kFileExists);
    std::ofstream(history_ / *name / "samples-1.csv", std::ios::app) << "\n";
    EXPECT_EQ(exportEntry(entry, folder_.path() / "two").error().code, ErrorCode::kFileChanged);
}

TEST_F(VehicleHistory, GivesTheVehicleFileWhatWasAccepted) {
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

TEST_F(VehicleHistory, KeepsARefusedCalibrationAndLeavesTheVehicleFile) {
    Calibration calibration{.procedure = "bias",
                            .found = {{"gyro_bias_rad_s", std::nullopt, {0.002, 1e-5, 20.0}}},
                            .verdict = Verdict::kRefused};
    const auto kept = keepInHistory(vehicle_, calibration, {}, {.time_utc = "now"});
    ASSERT_TRUE(kept);
    EXPECT_FALSE(kept->taken_over);
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
    EXPECT_EQ(historyEntry(history_, kept->entry)->record->verdict, Verdict::kRefused);
}

TEST_F(VehicleHistory, MakesAVehicleFileThatIsNotThereYet) {
    const fs::path fresh = folder_.path() / "fresh.toml";
    Calibration calibration{.procedure = "wheels",
                            .found = {{"wheelbase_m", 0.4, {0.5, 0.001}}},
                            .verdict = Verdict::kAccepted};
    ASSERT_TRUE(keepInHistory(fresh, calibration, {}, {.time_utc = "now"}));
    EXPECT_EQ(loadVehicle(fresh)->geometry.wheelbase_m, 0.5);
}

// Somebody else may have changed it since the samples were read.
TEST_F(VehicleHistory, ChangesNothingButWhatWasFound) {
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

TEST_F(VehicleHistory, WritesNothingThatItCouldNotReadAgain) {
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

TEST_F(VehicleHistory, SaysThatTheVehicleFileCouldNotTakeIt) {
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

TEST_F(VehicleHistory, TakesWhatSeveralProgramsFindAtOnce) {
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

TEST_F(VehicleHistory, RestoresAVehicleFileThatIsGone) {
    CalibrationRecord record = fullRecord();
    record.vehicle_after = text_;
    const auto name = keepCalibration(history_, record, {});
    ASSERT_TRUE(name);
    fs::remove(vehicle_);
    const auto entry = historyEntry(history_, *name);
    ASSERT_TRUE(restoreVehicle(vehicle_, *entry, RestoreTo::kAfter, "now", ""));
    EXPECT_EQ(readTextFile(vehicle_).value(), text_);
}

TEST_F(VehicleHistory, KeepsEachOfTwoOfTheSameSecond) {
    const auto first = keepCalibration(history_, fullRecord(), {});
    const auto second = keepCalibration(history_, fullRecord(), {});
    ASSERT_TRUE(first && second);
    EXPECT_NE(*first, *second);
    EXPECT_EQ(loadHistory(history_)->size(), 2U);
}

TEST_F(VehicleHistory, LeavesNothingWhereItCannotWrite) {
    std::ofstream(history_) << "a file where the folder should be";
    EXPECT_FALSE(keepCalibration(history_, fullRecord(), {{"live", someReports()}}));
}

}  // namespace
}  // namespace hedr
