#include "core/calibration/gyro/gyro_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/geometry/angle.h"
#include "core/robot/sensor_csv.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

struct StandingGyro {
    double noise = radFromDeg(0.02);
    double walk = 0.0;
    double period_s = 0.02;
};

// A gyro that stands: white noise and a walk of its bias.
std::vector<SensorReport> standing(const StandingGyro& gyro, std::size_t n, std::uint64_t seed) {
    Random random(seed);
    std::vector<SensorReport> reports;
    double bias = 0.01;
    for (std::size_t i = 0; i < n; ++i) {
        bias += gyro.walk * std::sqrt(gyro.period_s) * random.normal();
        const double rate = bias + gyro.noise / std::sqrt(gyro.period_s) * random.normal();
        reports.push_back({.robot_time_s = gyro.period_s * static_cast<double>(i),
                           .odometry = WheelTicks{7, 9},
                           .gyro = GyroRate{rate}});
    }
    return reports;
}

TEST(GyroNoise, FindsTheNoiseOfAStandingGyro) {
    const auto result = calibrateGyroNoise(standing({}, 60000, 1), {});
    ASSERT_TRUE(result.fit && result.fit->angle_walk_rad_s_sqrthz.found);
    EXPECT_NEAR(result.fit->angle_walk_rad_s_sqrthz.found->value, radFromDeg(0.02),
                radFromDeg(0.0005));
    EXPECT_FALSE(result.fit->rate_walk_rad_s_sqrts.found) << "there is none";
    EXPECT_EQ(result.calibration.verdict, Verdict::kAccepted) << result.calibration.reason;
}

TEST(GyroNoise, FindsTheWalkOfTheBias) {
    const double walk = radFromDeg(0.002);
    const auto result = calibrateGyroNoise(standing({.walk = walk}, 200000, 2), {});
    ASSERT_TRUE(result.fit && result.fit->rate_walk_rad_s_sqrts.found);
    EXPECT_TRUE(result.fit->rate_walk_rad_s_sqrts.interval.contains(walk));
}

// 400 records each: unbiased, and the intervals hold the truth.
TEST(GyroNoise, StatesHonestIntervals) {
    for (const std::size_t n : {600U, 3000U}) {
        int held = 0;
        double error = 0.0;
        double stated = 0.0;
        constexpr int kRuns = 400;
        for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
            const StandingGyro gyro{.noise = 1.0, .period_s = 0.1};
            std::vector<double> rates;
            for (const SensorReport& report : standing(gyro, n, seed))
                rates.push_back(std::get<GyroRate>(report.gyro).rad_s);
            const auto fit = fitGyroNoise(allanDeviation(rates, 0.1, octaveFactors(n)), 0.1);
            ASSERT_TRUE(fit && fit->angle_walk_rad_s_sqrthz.found);
            held += fit->angle_walk_rad_s_sqrthz.interval.contains(1.0) ? 1 : 0;
            error += fit->angle_walk_rad_s_sqrthz.found->value - 1.0;
            stated += fit->angle_walk_rad_s_sqrthz.found->standard_error;
        }
        std::printf("%zu readings: held in %.1f %%, mean error %.3f of what is stated\n", n,
                    100.0 * held / kRuns, error / stated);
        EXPECT_LT(std::abs(error), 0.2 * stated) << n;
        EXPECT_GE(held, kRuns * 93 / 100) << n;
        EXPECT_LE(held, kRuns * 97 / 100) << n;
    }
}

TEST(GyroNoise, RefusesWhatIsNoBasis) {
    const auto reasonFor = [](const std::vector<SensorReport>& reports) {
        const Calibration calibration = calibrateGyroNoise(reports, {}).calibration;
        EXPECT_EQ(calibration.verdict, Verdict::kRefused);
        EXPECT_TRUE(calibration.found.empty());
        return calibration.reason;
    };
    EXPECT_EQ(reasonFor({}), "No readings of a gyro have come.");
    EXPECT_NE(reasonFor(standing({}, 300, 1)).find("too short"), std::string::npos);
    EXPECT_NE(reasonFor(standing({.period_s = 10.0}, 200, 1)).find("are too few"),
              std::string::npos);
    auto clipped = standing({}, 5000, 1);
    for (SensorReport& report : clipped) {
        double& rate_rad_s = std::get<GyroRate>(report.gyro).rad_s;
        rate_rad_s = std::min(rate_rad_s, 0.012);
    }
    EXPECT_NE(reasonFor(clipped).find("end of its range"), std::string::npos);
    auto same = standing({}, 5000, 1);
    for (SensorReport& report : same) report.gyro = GyroRate{0.01};
    EXPECT_TRUE(reasonFor(same).starts_with("All readings"));
    auto moving = standing({}, 5000, 1);
    moving.back().odometry = WheelTicks{8, 9};
    EXPECT_NE(reasonFor(moving).find("wheels moved"), std::string::npos);
    auto broken = standing({}, 5000, 1);
    for (std::size_t i = 0; i < broken.size(); i += 10) broken[i].gyro = GyroRate{NAN};
    EXPECT_NE(reasonFor(broken).find("missing or broken"), std::string::npos);
}

TEST(GyroNoise, IsOfTheScaledRate) {
    Vehicle doubled;
    doubled.gyro_scale = 2.0;
    doubled.gyro_noise_rad_s_sqrthz = radFromDeg(0.04);
    const auto result = calibrateGyroNoise(standing({}, 20000, 1), doubled);
    EXPECT_EQ(result.calibration.verdict, Verdict::kUnchanged) << result.calibration.reason;
    const double found = result.calibration.found.front().now.value;
    EXPECT_NEAR(found, radFromDeg(0.04), radFromDeg(0.001));
    EXPECT_DOUBLE_EQ(result.calibration.figures.front().value, found);
    EXPECT_NEAR(result.calibration.proof->times_better, 1.0, 0.1);
}

TEST(GyroNoise, LeavesOutLoneReadings) {
    auto reports = standing({}, 20000, 3);
    for (std::size_t i = 100; i < reports.size(); i += 2000) reports[i].gyro = GyroRate{5.0};
    const auto result = calibrateGyroNoise(reports, {});
    ASSERT_TRUE(result.fit && result.fit->angle_walk_rad_s_sqrthz.found);
    EXPECT_NEAR(result.fit->angle_walk_rad_s_sqrthz.found->value, radFromDeg(0.02),
                radFromDeg(0.001));
    EXPECT_NE(result.calibration.remarks.front().find("left out"), std::string::npos);
}

struct Record {
    const char* folder;
    const char* column;
    double angle_walk_deg_sqrth;  // of its README
};

class GyroNoiseOfRecords : public testing::TestWithParam<Record> {};

TEST_P(GyroNoiseOfRecords, GetAVerdictWithIntervals) {
    const auto file = kRecordings / GetParam().folder / "sensors.csv";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    const auto log = loadSensorLog(file, GetParam().column);
    const auto result = calibrateGyroNoise(log->reports, {});
    ASSERT_TRUE(result.fit && result.fit->angle_walk_rad_s_sqrthz.found)
        << result.calibration.reason;
    const double noise = degFromRad(result.fit->angle_walk_rad_s_sqrthz.found->value) * 60.0;
    EXPECT_NEAR(noise, GetParam().angle_walk_deg_sqrth, 0.1 * GetParam().angle_walk_deg_sqrth);
    EXPECT_NE(result.calibration.remarks.back(), "");
    EXPECT_NE(result.calibration.verdict, Verdict::kRefused) << result.calibration.reason;
}

INSTANTIATE_TEST_SUITE_P(Records, GyroNoiseOfRecords,
                         testing::Values(Record{"static_adis16405_1", kGyroColumn, 2.335},
                                         Record{"static_adis16405_2", kGyroColumn, 2.294},
                                         Record{"static_mpu6050_10min", kGyroColumn, 0.555},
                                         Record{"static_mtig_contaminated", "gyro_x_rad_s", 2.101}),
                         [](const auto& each) { return std::string(each.param.folder); });

}  // namespace
}  // namespace hedr
