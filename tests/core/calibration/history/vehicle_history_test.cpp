#include "core/calibration/history/vehicle_history.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/robot/sensor_csv.h"
#include "tests/core/calibration/history/history_examples.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

using test::fullRecord;
using test::someReports;

class VehicleHistory : public test::VehicleWithHistory {};

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

TEST_F(VehicleHistory, WaitsForNoPipeThatLiesWhereARecordShould) {
    fs::create_directories(history_ / "entry");
    ASSERT_EQ(mkfifo((history_ / "entry" / "record.toml").c_str(), 0600), 0);
    const auto entries = loadHistory(history_);
    ASSERT_EQ(entries->size(), 1U);
    EXPECT_EQ(entries->front().record.error().code, ErrorCode::kFileUnreadable);
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

TEST_F(VehicleHistory, LeavesNothingWhereItCannotWrite) {
    std::ofstream(history_) << "a file where the folder should be";
    EXPECT_FALSE(keepCalibration(history_, fullRecord(), {{"live", someReports()}}));
}

}  // namespace
}  // namespace hedr
