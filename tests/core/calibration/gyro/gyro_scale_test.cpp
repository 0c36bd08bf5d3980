#include "core/calibration/gyro/gyro_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/robot/sensor_csv.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/gyro/turning_bench.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

using namespace test;

// Whether any of the remarks says that.
bool remarks(const Calibration& calibration, const std::string& words) {
    return std::any_of(calibration.remarks.begin(), calibration.remarks.end(),
                       [&](const auto& each) { return each.find(words) != std::string::npos; });
}

TEST(GyroScale, IsFoundAndProvenFromTurnsToAMark) {
    const GyroScale found = scaleOf({.turns = {4, -4, 4, -4, 4, -4}, .scale = 1.03}, 1);
    EXPECT_EQ(found.calibration.verdict, Verdict::kAccepted) << found.calibration.reason;
    EXPECT_NEAR(found.fit->both.value, 1.03, 0.004);
    ASSERT_TRUE(found.calibration.proof);
    EXPECT_EQ(found.calibration.proof->parts, 6U);
    EXPECT_NEAR(found.calibration.proof->before, radFromDeg(0.03 / 1.03 * 1440.0), radFromDeg(4.0));
    EXPECT_LT(found.calibration.proof->after, radFromDeg(5.0));
    EXPECT_GT(found.calibration.progress.share, 0.3);
}

// The new scale is a little worse than the true one, which held-out turns may notice.
TEST(GyroScale, IsUnchangedWhereItIsRight) {
    int unchanged = 0;
    int noticed = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const GyroScale found = scaleOf({.scale = 1.02}, seed, {.gyro_scale = 1.02});
        unchanged += found.calibration.verdict == Verdict::kUnchanged ? 1 : 0;
        noticed += found.calibration.verdict == Verdict::kRefused ? 1 : 0;
    }
    EXPECT_EQ(unchanged + noticed, 40);
    EXPECT_GE(unchanged, 30);
}

TEST(GyroScale, ChangesTheBiasInTheFileWithIt) {
    const Vehicle vehicle{
        .gyro_scale = 0.97, .gyro_bias_rad_s = 0.02, .gyro_drift = GyroDrift{0.003, -0.004, 300.0}};
    const GyroScale found = scaleOf({.turns = {4, -4, 4, -4, 4, -4}}, 2, vehicle);
    const auto changed = calibrated(vehicle, found.calibration);
    ASSERT_TRUE(changed);
    const double change = changed->gyro_scale / 0.97;
    EXPECT_NEAR(changed->gyro_scale, 1.02, 0.004);
    EXPECT_DOUBLE_EQ(*changed->gyro_bias_rad_s, 0.02 * change);
    EXPECT_DOUBLE_EQ(changed->gyro_drift->c1_rad_s, 0.003 * change);
    EXPECT_DOUBLE_EQ(changed->gyro_drift->c2_rad_s, -0.004 * change);
    EXPECT_EQ(changed->gyro_drift->time_s, 300.0);
    EXPECT_TRUE(remarks(found.calibration, "bias in the vehicle file"));
}

TEST(GyroScale, IsNotAcceptedFromOneDirection) {
    const GyroScale found = scaleOf({.turns = {4, 4, 4, 4, 4, 4}, .scale = 1.05}, 3);
    EXPECT_EQ(found.calibration.verdict, Verdict::kNotProven);
    EXPECT_NE(found.calibration.reason.find("one way only"), std::string::npos);
    EXPECT_NEAR(found.fit->both.value, 1.05, 0.003);
}

TEST(GyroScale, SaysWhereTheDirectionsDiffer) {
    const GyroScale found = scaleOf({.turns = {4, -4, 4, -4, 4, -4}, .difference = 0.02}, 4);
    EXPECT_NEAR(found.fit->difference->value, 0.02 / 1.02, 0.008);
    EXPECT_TRUE(remarks(found.calibration, "larger counter-clockwise"));
}

TEST(GyroScale, NamesABadTurn) {
    const GyroScale found = scaleOf({.turns = kFourEach, .bad_turn = 8, .bad_mark_deg = 30.0}, 5);
    EXPECT_TRUE(remarks(found.calibration, "Turn 8 is")) << found.calibration.remarks.size();
    EXPECT_EQ(found.held_out.size(), 7U);
}

TEST(GyroScale, AsksForTheNumberOfManyTurns) {
    const TurningBench bench{.turns = {10, -10, 10, -10}};
    const GyroScale untold = scaleOf(bench, 6);
    EXPECT_EQ(untold.calibration.verdict, Verdict::kRefused);
    EXPECT_NE(untold.calibration.reason.find("Say how many"), std::string::npos);
    EXPECT_NEAR(scaleOf(bench, 6, {}, {.turns = 10.0}).fit->both.value, 1.02, 0.003);
    // Where fewer turns tell the scale, more of them can be counted.
    const GyroScale mixed = scaleOf({.turns = {2, -2, 10, -10}}, 6);
    EXPECT_FALSE(mixed.turns.ambiguous);
    EXPECT_EQ(mixed.turns.whole.size(), 4U);
}

TEST(GyroScale, CountsTurnsOfAGyroThatIsATenthOff) {
    for (const double scale : {0.91, 1.0, 1.09}) {
        for (const int turns : {1, 2, 3, 4}) {
            const GyroScale found =
                scaleOf({.turns = {turns, -turns, turns, -turns}, .scale = scale}, 7);
            ASSERT_TRUE(found.fit) << found.calibration.reason;
            EXPECT_EQ(found.turns.whole.size(), 4U);
            EXPECT_NEAR(found.fit->both.value, scale, 0.025 / turns);
        }
    }
}

TEST(GyroScale, LeavesOutTurnsThatAreNotWhole) {
    BenchLog log({.turns = kFourEach}, 8);
    log.turn(500.0);
    log.stand(5.0);
    const GyroScale found = calibrateGyroScale(std::vector{log.set}, {});
    EXPECT_EQ(found.turns.whole.size(), 8U);
    EXPECT_TRUE(remarks(found.calibration, "Turn 9 was left out"));
}

TEST(GyroScale, JoinsPiecesOfATurnAndMovesBackToTheMark) {
    BenchLog log({.turns = {}, .scale = 1.0, .mark_deg = 0.0}, 9);
    for (const double piece_deg : {180.0, 180.0, 372.0, -12.0}) {
        log.turn(piece_deg);
        log.stand(4.0);
    }
    const GyroScale found = calibrateGyroScale(std::vector{log.set}, {});
    ASSERT_EQ(found.turns.whole.size(), 2U);
    EXPECT_TRUE(found.turns.others.empty());
    for (const GyroTurn& turn : found.turns.whole) {
        EXPECT_NEAR(turn.reported_rad, 2.0 * kPi, radFromDeg(2.0));
    }
}

TEST(GyroScale, IsFoundFromClosedDrives) {
    std::vector<SampleSet> drives;
    for (int i = 0; i < 6; ++i) {
        BenchLog log({.turns = {}, .scale = 1.04}, static_cast<std::uint64_t>(20 + i));
        for (int side = 0; side < 4; ++side) {
            log.stand(3.0);
            log.turn(i % 2 == 0 ? 90.0 : -90.0);
        }
        log.stand(5.0);
        drives.push_back(log.set);
    }
    const GyroScale found = calibrateGyroScale(drives, {}, {.closed = true});
    EXPECT_EQ(found.turns.whole.size(), 6U);
    EXPECT_NEAR(found.fit->both.value, 1.04, found.fit->both.margin(0.999));
    EXPECT_EQ(found.calibration.verdict, Verdict::kAccepted) << found.calibration.reason;
}

TEST(GyroScale, IsRefusedWithTheReason) {
    const auto reasonOf = [](const std::vector<SampleSet>& sets) {
        const GyroScale found = calibrateGyroScale(sets, {});
        EXPECT_EQ(found.calibration.verdict, Verdict::kRefused);
        return found.calibration.reason;
    };
    const auto contains = [](const std::string& reason, const char* words) {
        return reason.find(words) != std::string::npos ? "" : reason + " lacks " + words;
    };
    EXPECT_EQ(contains(reasonOf({}), "No gyro readings"), "");
    EXPECT_EQ(contains(reasonOf({SampleSet{}}), "No gyro readings"), "");
    EXPECT_EQ(contains(reasonOf({logOf({.turns = {}}, 1)}), "has not stood, turned"), "");
    EXPECT_EQ(contains(reasonOf({logOf({.range_deg_s = 60.0}, 2)}), "Turn it slower"), "");
    BenchLog half({.turns = {}}, 3);
    half.turn(180.0);
    half.stand(5.0);
    EXPECT_EQ(contains(reasonOf({half.set}), "no whole number of turns"), "");
    SampleSet broken = logOf({}, 4);
    for (std::size_t i = 0; i < broken.reports.size(); i += 5) {
        broken.reports[i].gyro = GyroRate{NAN};
    }
    EXPECT_EQ(contains(reasonOf({broken}), "are no numbers"), "");
    SampleSet equal = logOf({}, 5);
    for (SensorReport& report : equal.reports) report.gyro = GyroRate{0.1};
    EXPECT_EQ(contains(reasonOf({equal}), "has not stood, turned"), "");
    SampleSet other_way = logOf({}, 6);
    double heading_rad = 0.0;
    for (SensorReport& report : other_way.reports) {
        heading_rad -= std::get<GyroRate>(report.gyro).rad_s / 25.0;
        if (std::abs(std::get<GyroRate>(report.gyro).rad_s) < 0.05) heading_rad = 0.0;
        report.odometry = OdometryPose{0.0, 0.0, heading_rad};
    }
    EXPECT_NE(reasonOf({other_way}), "");
}

TEST(GyroScale, LeavesOutATurnWithAGapInItsReadings) {
    SampleSet set = logOf({.turns = kFourEach}, 10);
    auto& reports = set.reports;
    const auto moving = std::find_if(reports.begin(), reports.end(), [](const auto& report) {
        return std::get<GyroRate>(report.gyro).rad_s > radFromDeg(60.0);
    });
    reports.erase(moving, moving + 20);
    const GyroScale found = calibrateGyroScale(std::vector{set}, {});
    EXPECT_EQ(found.turns.whole.size(), 7U);
    EXPECT_TRUE(remarks(found.calibration, "no gyro readings came for"));
}

TEST(GyroScale, BearsLoneWildReadings) {
    SampleSet set = logOf({.turns = kFourEach}, 11);
    for (std::size_t i = 7; i < set.reports.size(); i += 97) {
        set.reports[i].gyro = GyroRate{radFromDeg(i % 2 == 0 ? 900.0 : -900.0)};
    }
    const GyroScale found = calibrateGyroScale(std::vector{set}, {});
    ASSERT_TRUE(found.fit) << found.calibration.reason;
    EXPECT_NEAR(found.fit->both.value, 1.02, 0.006);
}

TEST(GyroScale, IsSensibleHoweverFarItHasCome) {
    const SampleSet whole = logOf({.turns = kTwoEach}, 12);
    double share = 0.0;
    for (std::size_t count = 0; count <= whole.reports.size(); count += 100) {
        SampleSet part;
        part.reports.assign(whole.reports.begin(),
                            whole.reports.begin() + static_cast<std::ptrdiff_t>(count));
        const GyroScale found = calibrateGyroScale(std::vector{part}, {});
        EXPECT_FALSE(found.calibration.reason.empty());
        EXPECT_EQ(found.calibration.steps.size(), 3U);
        share = found.calibration.progress.share;
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
    }
    EXPECT_GT(share, 0.0);
}

SampleSet recordingOf(const char* name) {
    const auto log = loadSensorLog(kRecordings / name / "sensors.csv");
    return log ? SampleSet{name, log->reports} : SampleSet{};
}

// The static log of the same board stands before and after the turns.
TEST(GyroScaleRecordings, HandTurnsReadThreePercentLess) {
    const SampleSet turns = recordingOf("mag_gyro_flat_rotation");
    const SampleSet still = recordingOf("static_mpu6050_10min");
    if (turns.reports.empty() || still.reports.empty())
        GTEST_SKIP() << "The recordings are absent.";
    SampleSet joined;
    const auto append = [&joined](std::vector<SensorReport> reports) {
        const double at_s =
            joined.reports.empty() ? 0.0 : joined.reports.back().robot_time_s + 0.02;
        const double from_s = reports.front().robot_time_s;
        for (SensorReport& report : reports) {
            report.robot_time_s += at_s - from_s;
            joined.reports.push_back(report);
        }
    };
    const std::vector<SensorReport> stand(still.reports.end() - 1000, still.reports.end());
    append(stand);
    append(turns.reports);
    append(stand);
    const GyroScale found = calibrateGyroScale(std::vector{joined}, {}, {.turns = 2.0});
    ASSERT_EQ(found.turns.whole.size(), 1U) << found.calibration.reason;
    EXPECT_NEAR(degFromRad(found.turns.whole[0].reported_rad), 703.4, 0.5);
    EXPECT_NEAR(found.fit->both.value, 720.0 / 703.4, 0.001);
    EXPECT_NE(found.calibration.verdict, Verdict::kAccepted);
}

TEST(GyroScaleRecordings, TurnsThatAreNotWholeAreMeasuredAndRefused) {
    const SampleSet roomba = recordingOf("roomba_mag_1_notruth");
    if (roomba.reports.empty()) GTEST_SKIP() << "The recordings are absent.";
    const auto vehicle = loadVehicle(kRecordings / "roomba_mag_1_notruth/vehicle.toml");
    const GyroScale turned = calibrateGyroScale(std::vector{roomba}, *vehicle, {.closed = true});
    ASSERT_EQ(turned.turns.others.size(), 1U);
    // Its README has -556.4 with the bias of the first stand only.
    EXPECT_NEAR(degFromRad(turned.turns.others[0].reported_rad), -556.4, 1.0);
    EXPECT_NEAR(degFromRad(*turned.turns.others[0].wheels_rad), -561.6, 0.5);
    EXPECT_EQ(turned.calibration.verdict, Verdict::kRefused);
}

}  // namespace
}  // namespace hedr
