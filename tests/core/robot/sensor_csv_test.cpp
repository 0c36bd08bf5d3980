#include "core/robot/sensor_csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

class SensorCsv : public testing::Test {
  protected:
    Result<SensorLog> load(const std::string& text) {
        std::ofstream(file_, std::ios::binary) << text;
        return loadSensorLog(file_);
    }
    std::vector<SensorReport> reportsOf(const std::string& text) {
        const auto log = load(text);
        EXPECT_TRUE(log) << log.error().subject << ": " << log.error().detail;
        return log ? log->reports : std::vector<SensorReport>{};
    }
    Error errorOf(const std::string& text) {
        const auto log = load(text);
        EXPECT_FALSE(log);
        return log ? Error{} : log.error();
    }
    std::string line(int number) const { return file_.string() + ':' + std::to_string(number); }

    ScratchFolder folder_;
    std::filesystem::path file_ = folder_.path() / "sensors.csv";
};

TEST_F(SensorCsv, ReadsTicksAndGyroInAnyColumnOrder) {
    const auto reports = reportsOf("gyro_z_rad_s,right_ticks,t_s,left_ticks\n0.5,-20,1.25,10\n");
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_EQ(reports[0].robot_time_s, 1.25);
    EXPECT_EQ(reports[0].odometry, Odometry(WheelTicks{10, -20}));
    EXPECT_EQ(reports[0].gyro, Gyro(GyroRate{0.5}));
}

TEST_F(SensorCsv, ReadsEveryKindOfOdometry) {
    EXPECT_EQ(reportsOf("t_s,left_m,right_m\n0,1.5,2.5\n")[0].odometry,
              Odometry(WheelTravel{1.5, 2.5}));
    EXPECT_EQ(reportsOf("t_s,dist_m\n0,1.5\n")[0].odometry, Odometry(PathTravel{1.5}));
    EXPECT_EQ(reportsOf("t_s,odo_x_m,odo_y_m,odo_heading_rad\n0,1,2,3\n")[0].odometry,
              Odometry(OdometryPose{1.0, 2.0, 3.0}));
}

TEST_F(SensorCsv, PrefersTicksToMetresToAPoseToDistance) {
    const std::string pose = "dist_m,odo_x_m,odo_y_m,odo_heading_rad";
    EXPECT_EQ(reportsOf("t_s," + pose +
                        ",left_m,right_m,left_ticks,right_ticks\n"
                        "0,9,1,2,3,4,5,6,7\n")[0]
                  .odometry,
              Odometry(WheelTicks{6, 7}));
    EXPECT_EQ(reportsOf("t_s," + pose + ",left_m,right_m\n0,9,1,2,3,4,5\n")[0].odometry,
              Odometry(WheelTravel{4.0, 5.0}));
    EXPECT_EQ(reportsOf("t_s," + pose + "\n0,9,1,2,3\n")[0].odometry,
              Odometry(OdometryPose{1.0, 2.0, 3.0}));
}

TEST_F(SensorCsv, ReadsTemperatureAndMagneticField) {
    const auto reports =
        reportsOf("t_s,gyro_z_rad_s,temperature_c,mag_x,mag_y,mag_z\n0,0,25.5,1,2,3\n");
    EXPECT_EQ(reports[0].temperature_c, 25.5);
    EXPECT_EQ(reports[0].magnetic_field, (MagneticField{1.0, 2.0, 3.0}));
}

TEST_F(SensorCsv, ToleratesByteOrderMarkCarriageReturnsAndBlankLines) {
    const auto reports =
        reportsOf("\xEF\xBB\xBFt_s , gyro_z_rad_s\r\n\r\n 0 , 1 \r\n\n1,+2.5e-3\r\n\r\n");
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(reports[1].gyro, Gyro(GyroRate{2.5e-3}));
}

TEST_F(SensorCsv, TakesAnEmptyOrNanFieldAsMissingInThatRow) {
    const auto reports = reportsOf(
        "t_s,left_ticks,right_ticks,gyro_z_rad_s,temperature_c,mag_x,mag_y,mag_z\n"
        "0,1,,nan,,1,2,nan\n"
        "1,1,2,0.5,20,1,2,3\n");
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(reports[0], (SensorReport{0.0, {}, {}, {}, {}}));
    EXPECT_EQ(reports[1].odometry, Odometry(WheelTicks{1, 2}));
    EXPECT_TRUE(reports[1].magnetic_field);
}

TEST_F(SensorCsv, TakesWholeNumbersThatASpreadsheetRewrote) {
    EXPECT_EQ(reportsOf("t_s,left_ticks,right_ticks\n0,12.0,1e3\n")[0].odometry,
              Odometry(WheelTicks{12, 1000}));
}

TEST_F(SensorCsv, ListsTheColumnsThatItIgnores) {
    const auto log = load("t_s,gyro_z_rad_s,battery_v\n0,0,12\n");
    ASSERT_TRUE(log);
    EXPECT_EQ(log->ignored_columns, std::vector<std::string>{"battery_v"});
}

TEST_F(SensorCsv, TellsMissingUnreadableAndEmptyFilesApart) {
    EXPECT_EQ(loadSensorLog(folder_.path() / "none.csv").error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(loadSensorLog(folder_.path()).error().code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(errorOf("").code, ErrorCode::kFileEmpty);
    EXPECT_EQ(errorOf("\n\n").code, ErrorCode::kFileEmpty);
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\n").code, ErrorCode::kFileEmpty);
}

TEST_F(SensorCsv, NamesTheMissingColumn) {
    const Error no_time = errorOf("gyro_z_rad_s\n0\n");
    EXPECT_EQ(no_time.code, ErrorCode::kMissingColumn);
    EXPECT_EQ(no_time.detail, "t_s");
    const Error half_a_pair = errorOf("t_s,left_ticks\n0,1\n");
    EXPECT_EQ(half_a_pair.code, ErrorCode::kMissingColumn);
    EXPECT_EQ(half_a_pair.detail, "right_ticks");
    const Error nothing_to_use = errorOf("t_s,gyro_x_rad_s\n0,1\n");
    EXPECT_EQ(nothing_to_use.code, ErrorCode::kMissingColumn);
    EXPECT_TRUE(nothing_to_use.detail.starts_with("gyro_z_rad_s"));
}

TEST_F(SensorCsv, NamesLineAndColumnOfATextInANumberColumn) {
    const Error error = errorOf("t_s,gyro_z_rad_s\n0,1\n1,fast\n");
    EXPECT_EQ(error.code, ErrorCode::kBadFormat);
    EXPECT_EQ(error.subject, line(3));
    EXPECT_EQ(error.detail, "gyro_z_rad_s is \"fast\", must be a number");
    EXPECT_EQ(errorOf("t_s,left_ticks,right_ticks\n0,1,2.5\n").detail,
              "right_ticks is \"2.5\", must be a whole number");
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\n0,inf\n").code, ErrorCode::kBadFormat);
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\n0,0x1p3\n").code, ErrorCode::kBadFormat);
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\n0,1e999\n").code, ErrorCode::kBadFormat);
}

TEST_F(SensorCsv, NeedsAFiniteTimeInEveryRow) {
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\nnan,1\n").detail, "t_s is \"nan\", must be a number");
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\n,1\n").detail, "t_s is empty, must be a number");
}

TEST_F(SensorCsv, NamesLineAndColumnWhereARowEndsEarly) {
    const Error error = errorOf("t_s,left_ticks,right_ticks\n0,1,2\n1,1\n");
    EXPECT_EQ(error.code, ErrorCode::kBadFormat);
    EXPECT_EQ(error.subject, line(3));
    EXPECT_EQ(error.detail, "the row has 2 fields, the header has 3, right_ticks is missing");
    EXPECT_EQ(errorOf("t_s,gyro_z_rad_s\n0,1,2\n").subject, line(2));
}

TEST_F(SensorCsv, RefusesAColumnThatOccursTwice) {
    EXPECT_EQ(errorOf("t_s,t_s,gyro_z_rad_s\n0,0,0\n").code, ErrorCode::kBadFormat);
}

TEST_F(SensorCsv, RefusesBytesThatAreNoText) {
    EXPECT_EQ(errorOf(std::string("\x89PNG\r\n\x1a\n\0\0\0", 11)).code, ErrorCode::kBadFormat);
}

RC_GTEST_FIXTURE_PROP(SensorCsv, NeverCrashesOnAnyText, ()) {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::element('t', '_', 's', ',', '\n', '\r', '1', '-', '.', 'e', ' ', '\0', '\xEF'));
    load("t_s,gyro_z_rad_s\n0,0\n" + text);
    load(text);
}

SensorReport anyReport() {
    SensorReport report;
    const auto number = [] { return *rc::gen::inRange(-1000000, 1000000) / 7.0; };
    report.robot_time_s = number();
    report.odometry = WheelTicks{*rc::gen::arbitrary<std::int64_t>(), -5};
    if (*rc::gen::arbitrary<bool>()) report.gyro = GyroRate{number()};
    if (*rc::gen::arbitrary<bool>()) report.temperature_c = number();
    if (*rc::gen::arbitrary<bool>())
        report.magnetic_field = MagneticField{number(), number(), number()};
    return report;
}

RC_GTEST_FIXTURE_PROP(SensorCsv, WritesWhatItReads, ()) {
    std::vector<SensorReport> reports;
    const int count = *rc::gen::inRange(1, 20);
    for (int i = 0; i < count; ++i) reports.push_back(anyReport());
    RC_ASSERT(saveSensorLog(file_, reports).has_value());
    const auto log = loadSensorLog(file_);
    RC_ASSERT(log.has_value());
    RC_ASSERT(log->reports == reports);
}

TEST_F(SensorCsv, SaysWhereItCannotWrite) {
    EXPECT_EQ(saveSensorLog("/nowhere/sensors.csv", {}).error().code, ErrorCode::kFileUnwritable);
    EXPECT_EQ(saveSensorLog(folder_.path(), {}).error().code, ErrorCode::kFileUnwritable);
}

TEST_F(SensorCsv, SaysThatTheDiskIsFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    const auto saved = saveSensorLog("/dev/full", {SensorReport{}});
    EXPECT_EQ(saved.error().code, ErrorCode::kDiskFull);
    EXPECT_EQ(saved.error().subject, "/dev/full");
}

TEST(RecordedSensorCsv, LoadsWhereItHasUsableColumns) {
    if (!std::filesystem::exists(kRecordings)) GTEST_SKIP() << kRecordings << " is not here";
    const std::set<std::string> without = {"static_mtig_contaminated"};
    int count = 0;
    for (const auto& folder : std::filesystem::directory_iterator(kRecordings)) {
        const auto file = folder.path() / "sensors.csv";
        if (!std::filesystem::exists(file)) continue;
        const auto log = loadSensorLog(file);
        if (without.count(folder.path().filename().string())) {
            EXPECT_EQ(log.error().code, ErrorCode::kMissingColumn) << file;
            EXPECT_TRUE(log.error().detail.starts_with("gyro_z_rad_s")) << file;
        } else {
            ASSERT_TRUE(log) << log.error().subject << ": " << log.error().detail;
            EXPECT_GT(log->reports.size(), 40U) << file;
            ++count;
        }
    }
    EXPECT_GT(count, 15);
}

TEST(RecordedSensorCsv, ReadsAFieldAlone) {
    const auto file = kRecordings / "magcal_hmc5883l_sphere/sensors.csv";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    const auto log = loadSensorLog(file);
    ASSERT_TRUE(log);
    EXPECT_EQ(log->reports.size(), 8190U);
    EXPECT_EQ(log->reports[0].magnetic_field, (MagneticField{0.241284, -0.337615, -0.388991}));
    EXPECT_TRUE(std::holds_alternative<std::monostate>(log->reports[0].gyro));
}

TEST(RecordedSensorCsv, HasTheRowsAndKindThatItsReadmeTells) {
    const auto file = kRecordings / "tuc_corridor/sensors.csv";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    const auto log = loadSensorLog(file);
    ASSERT_TRUE(log);
    EXPECT_EQ(log->reports.size(), 22692U);
    EXPECT_TRUE(std::holds_alternative<OdometryPose>(log->reports[0].odometry));
    EXPECT_EQ(log->ignored_columns, (std::vector<std::string>{"v_m_s", "yaw_rate_odo_rad_s"}));
}

}  // namespace
}  // namespace hedr
