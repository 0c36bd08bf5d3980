#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <span>

#include "core/calibration/gyro/warmup.h"
#include "core/geometry/angle.h"
#include "core/robot/sensor_csv.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

struct WarmRecord {
    const char* file;
    const char* column;
};

class WarmupOfARealGyro : public testing::TestWithParam<WarmRecord> {};

// All of them have been on for long.
TEST_P(WarmupOfARealGyro, IsNotFound) {
    const auto file = kRecordings / GetParam().file;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "The real recordings are not here.";
    const auto log = loadSensorLog(file, GetParam().column);
    ASSERT_TRUE(log);
    const Warmup warmup = calibrateWarmup(log->reports, {});
    std::cout << GetParam().file << ": " << warmup.calibration.reason << '\n';
    EXPECT_EQ(warmup.calibration.verdict, Verdict::kRefused);
    EXPECT_TRUE(warmup.calibration.found.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Recorded, WarmupOfARealGyro,
    testing::Values(WarmRecord{"static_mpu6050_10min/sensors.csv", "gyro_z_rad_s"},
                    WarmRecord{"static_adis16405_1/sensors.csv", "gyro_z_rad_s"},
                    WarmRecord{"static_adis16405_2/sensors.csv", "gyro_z_rad_s"},
                    WarmRecord{"static_mtig_contaminated/sensors.csv", "gyro_x_rad_s"}));

// Parts of the records, as if the gyro had been switched on there.
TEST(WarmupOfRealGyros, DISABLED_IsRarelyFoundInPartsOfStandingRecords) {
    int parts = 0;
    int found = 0;
    for (const char* name : {"static_adis16405_1", "static_adis16405_2"}) {
        const auto log = loadSensorLog(kRecordings / name / "sensors.csv");
        if (!log) GTEST_SKIP() << "The real recordings are not here.";
        for (const std::size_t length : {6000U, 12000U, 18000U, 36000U}) {
            for (std::size_t i = 0; i + length <= log->reports.size(); i += length / 2) {
                const std::span all(log->reports);
                const Warmup warmup = calibrateWarmup(all.subspan(i, length), {});
                ++parts;
                found += warmup.calibration.found.empty() ? 0 : 1;
                if (warmup.calibration.found.empty()) continue;
                std::cout << name << " from " << i << ", " << length << ": C1 "
                          << degFromRad(warmup.fit->curve.c1_rad_s) << " T "
                          << warmup.fit->curve.time_s << " verdict "
                          << static_cast<int>(warmup.calibration.verdict) << '\n';
            }
        }
    }
    std::cout << found << " of " << parts << '\n';
    EXPECT_LE(found, 0.01 * parts);
}

}  // namespace
}  // namespace hedr
