// The encoders of real robots.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/calibration/encoders/encoder_check.h"
#include "core/robot/sensor_csv.h"

namespace hedr {
namespace {

const std::filesystem::path kRecordings = HEDR_SOURCE_DIR "/../shared/data";

using enum EncoderFault;

// A piece of a recording, with a moment of standing before and after it.
SampleSet pieceOf(const std::vector<SensorReport>& reports, double from_s, double to_s) {
    SampleSet piece;
    const auto stand = [&piece](SensorReport at, double t_s) {
        at.gyro = {};
        for (int i = 0; i < 20; ++i) {
            at.robot_time_s = t_s + 0.05 * i;
            piece.reports.push_back(at);
        }
    };
    for (const SensorReport& report : reports) {
        if (report.robot_time_s < from_s || report.robot_time_s > to_s) continue;
        if (piece.reports.empty()) stand(report, from_s - 1.0);
        piece.reports.push_back(report);
    }
    if (!piece.reports.empty()) stand(piece.reports.back(), to_s + 0.05);
    return piece;
}

struct RealRun {
    const char* name;
    double push_from_s, push_to_s, distance_m;
    double spin_from_s, spin_to_s, turns;
};

// The distances are the makers' figures for the Roombas, and the cameras' for the other one.
const RealRun kRoomba1{"roomba_mag_1_notruth", 1.5, 13.0, 0.8, 13.0, 29.5, -560.0 / 360.0};
const RealRun kRoomba2{"roomba_mag_2_notruth", 0.5, 13.5, 0.85, 13.5, 20.5, -207.0 / 360.0};

class RealEncoders : public testing::TestWithParam<RealRun> {
  protected:
    void SetUp() override {
        const auto folder = kRecordings / GetParam().name;
        const auto log = loadSensorLog(folder / "sensors.csv");
        if (!log) GTEST_SKIP() << "The recording is absent.";
        vehicle = *loadVehicle(folder / "vehicle.toml");
        const RealRun& run = GetParam();
        sets = {pieceOf(log->reports, run.push_from_s, run.push_to_s),
                pieceOf(log->reports, run.spin_from_s, run.spin_to_s)};
    }
    EncoderCheck check() const {
        return checkEncoders(sets, vehicle,
                             {.distance_m = GetParam().distance_m, .turns = GetParam().turns});
    }
    // Every report of encoders changed.
    template <class Change>
    EncoderFault faultAfter(const Change& change) {
        const auto was = sets;
        for (SampleSet& set : sets) {
            for (SensorReport& report : set.reports) {
                auto& ticks = std::get<WheelTicks>(report.odometry);
                change(ticks);
            }
        }
        const EncoderCheck changed = check();
        sets = was;
        EXPECT_EQ(changed.findings.size(), 1U);
        return changed.findings.empty() ? kNotOnTheSpot : changed.findings[0].fault;
    }

    Vehicle vehicle{};
    std::vector<SampleSet> sets{};
};

TEST_P(RealEncoders, AreRight) {
    const EncoderCheck right = check();
    EXPECT_TRUE(right.findings.empty()) << right.calibration.reason;
    EXPECT_EQ(right.calibration.verdict, Verdict::kUnchanged);
}

TEST_P(RealEncoders, WithAFaultAreNamed) {
    EXPECT_EQ(faultAfter([](WheelTicks& t) { std::swap(t.left, t.right); }), kSwapped);
    EXPECT_EQ(faultAfter([](WheelTicks& t) { t.left = -t.left; }), kReversed);
    EXPECT_EQ(faultAfter([](WheelTicks& t) { t.right = 0; }), kSilent);
    EXPECT_EQ(faultAfter([](WheelTicks& t) { t = {4 * t.left, 4 * t.right}; }), kWrongRatio);
    EXPECT_EQ(faultAfter([](WheelTicks& t) { t.right /= 2; }), kWrongRatio);
    // A fifteenth of each revolution does not count.
    EXPECT_EQ(faultAfter([](WheelTicks& t) {
                  const std::int64_t turns = t.left / 509, rest = t.left % 509;
                  t.left = turns * 484 + std::max<std::int64_t>(0, rest - 25);
              }),
              kMissingCounts);
}

INSTANTIATE_TEST_SUITE_P(Roombas, RealEncoders, testing::Values(kRoomba1, kRoomba2),
                         [](const auto& run) { return std::string(run.param.name); });

TEST(RealEncoders, OfTheMbotGoStraightByWhatTheCamerasSaw) {
    const auto log = loadSensorLog(kRecordings / "mbot_square/sensors.csv");
    if (!log) GTEST_SKIP() << "The recording is absent.";
    const auto vehicle = loadVehicle(kRecordings / "mbot_square/vehicle.toml");
    const std::vector sets{pieceOf(log->reports, 8.0, 10.9)};
    const EncoderCheck pushed = checkEncoders(sets, *vehicle, {.distance_m = 0.974});
    EXPECT_TRUE(pushed.findings.empty()) << pushed.calibration.reason;
    EXPECT_EQ(pushed.calibration.verdict, Verdict::kNotProven);
}

}  // namespace
}  // namespace hedr
