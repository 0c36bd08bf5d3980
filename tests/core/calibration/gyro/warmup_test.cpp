#include "core/calibration/gyro/warmup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/gyro/warmup_blocks.h"
#include "tests/core/calibration/gyro/warmup_stand.h"

namespace hedr {
namespace {

Warmup warmupOf(const Stand& stand, std::uint64_t seed = 1, const Vehicle& believed = {},
                const WarmupOptions& options = {}) {
    Random random(seed);
    return calibrateWarmup(reportsOf(stand, random), believed, options);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const Verdict kAccepted = Verdict::kAccepted;
const Verdict kRefused = Verdict::kRefused;

TEST(WarmupCalibration, FindsTheGyrostarsCurve) {
    const Warmup warmup = warmupOf({});
    const Calibration& calibration = warmup.calibration;
    ASSERT_EQ(calibration.verdict, kAccepted) << calibration.reason;
    EXPECT_TRUE(warmup.whiteness.isWhite());
    EXPECT_LE(warmup.fit->iterations, 10);
    ASSERT_EQ(calibration.found.size(), 3U);
    EXPECT_TRUE(calibration.found[0].now.interval(0.999).contains(kGyrostar.c1_rad_s));
    EXPECT_TRUE(calibration.found[1].now.interval(0.999).contains(kGyrostar.c2_rad_s));
    EXPECT_TRUE(calibration.found[2].now.interval(0.999).contains(kGyrostar.time_s));
    EXPECT_GT(calibration.proof->times_better, 5.0);
    EXPECT_EQ(calibration.progress.share, 1.0);
    EXPECT_EQ(calibration.plots.size(), 2U);
    EXPECT_TRUE(calibrated(Vehicle{}, calibration)->gyro_drift.has_value());
}

TEST(WarmupCalibration, RefusesAColdThatItWasTooLateToSee) {
    const Warmup warmup = warmupOf({.minutes = 30.0}, 1, {}, {.on_before_s = 1800.0});
    EXPECT_EQ(warmup.calibration.verdict, kRefused);
    EXPECT_TRUE(contains(warmup.calibration.reason, "when cold")) << warmup.calibration.reason;
}

TEST(WarmupCalibration, RefusesALogInOtherUnits) {
    Random random(1);
    auto reports = reportsOf({.minutes = 30.0}, random);
    for (SensorReport& report : reports) report.robot_time_s *= 1000.0;
    const Warmup slow = calibrateWarmup(reports, {}, {});
    EXPECT_EQ(slow.calibration.verdict, kRefused);
    EXPECT_TRUE(contains(slow.calibration.reason, "in seconds")) << slow.calibration.reason;
    Vehicle scaled;
    scaled.gyro_scale = 1000.0;
    EXPECT_TRUE(contains(warmupOf({}, 1, scaled).calibration.reason, "too much for a bias"));
}

// The file's numbers hold after the scale, as core/robot/motion.h applies them.
TEST(WarmupCalibration, FindsTheCurveAfterTheScale) {
    Vehicle doubled;
    doubled.gyro_scale = 2.0;
    const Warmup once = warmupOf({});
    const Warmup twice = warmupOf({}, 1, doubled);
    ASSERT_EQ(twice.calibration.found.size(), 3U);
    EXPECT_NEAR(twice.fit->curve.c1_rad_s / once.fit->curve.c1_rad_s, 2.0, 1e-6);
    EXPECT_NEAR(twice.fit->curve.c2_rad_s / once.fit->curve.c2_rad_s, 2.0, 1e-6);
    EXPECT_NEAR(twice.fit->curve.time_s, once.fit->curve.time_s, 1e-3);
}

TEST(WarmupCalibration, CountsTimeFromWhenItWasSwitchedOn) {
    Random random(2);
    const Stand stand{.minutes = 30.0, .begin_s = 4000.0, .on_before_s = 120.0};
    const Warmup warmup = calibrateWarmup(reportsOf(stand, random), {}, {.on_before_s = 120.0});
    ASSERT_EQ(warmup.calibration.verdict, kAccepted) << warmup.calibration.reason;
    EXPECT_TRUE(warmup.calibration.found[1].now.interval(0.999).contains(kGyrostar.c2_rad_s));
    EXPECT_NEAR(warmup.on_s, 120.0 + 1800.0, 1.0);
}

TEST(WarmupCalibration, SaysWhatItCostsToStartNow) {
    const Warmup warmup = warmupOf({.minutes = 12.0}, 3);
    ASSERT_TRUE(warmup.cost);
    const double left_rad_s = kGyrostar.c1_rad_s * std::exp(-720.0 / kGyrostar.time_s);
    const double x = 600.0 / kGyrostar.time_s;
    const double held_rad_s = left_rad_s * (1.0 + std::expm1(-x) / x);
    EXPECT_NEAR(warmup.cost->held_rad_s, held_rad_s, 0.6 * held_rad_s);
    ASSERT_TRUE(warmup.settled_in_s);
    const double matters_rad_s = WarmupOptions{}.matters_rad_s;
    const double settled_s = kGyrostar.time_s * std::log(kGyrostar.c1_rad_s / matters_rad_s);
    EXPECT_NEAR(*warmup.settled_in_s, settled_s - 720.0, 0.5 * settled_s);
    EXPECT_TRUE(contains(warmup.calibration.remarks.front(), "Start now with the bias as it is"));
}

TEST(WarmupCalibration, KnowsMoreAndMore) {
    double share = 0.0;
    for (const double minutes : {1.0, 6.0, 10.0, 14.0, 25.0}) {
        const Warmup warmup = warmupOf({.minutes = minutes}, 4);
        EXPECT_GE(warmup.calibration.progress.share, share) << minutes;
        share = warmup.calibration.progress.share;
    }
    EXPECT_EQ(share, 1.0);
}

TEST(WarmupCalibration, SaysThatItIsTooEarly) {
    const Warmup warmup = warmupOf({.minutes = 8.0}, 5);
    EXPECT_EQ(warmup.calibration.verdict, kRefused);
    EXPECT_TRUE(contains(warmup.calibration.reason, "too early") ||
                contains(warmup.calibration.reason, "straight line"))
        << warmup.calibration.reason;
    EXPECT_TRUE(warmup.calibration.found.empty());
}

TEST(WarmupCalibration, SaysThatTheGyroIsWarm) {
    int warm = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Warmup warmup =
            warmupOf({.curve = {0.0, 0.01, 300.0}, .minutes = 15.0, .rate_hz = 10.0}, seed);
        EXPECT_EQ(warmup.calibration.verdict, kRefused);
        warm += contains(warmup.calibration.reason, "already warm") ? 1 : 0;
    }
    EXPECT_GE(warm, 49);
}

struct Trouble {
    const char* name;
    Stand stand;
    const char* reason;
};

class TroubledWarmup : public testing::TestWithParam<Trouble> {};

// Noise itself looks like another trouble in one record of fifty.
TEST_P(TroubledWarmup, IsRefused) {
    constexpr int kRecords = 10;
    int told = 0;
    for (std::uint64_t seed = 0; seed < kRecords; ++seed) {
        const Warmup warmup = warmupOf(GetParam().stand, seed);
        EXPECT_EQ(warmup.calibration.verdict, kRefused) << seed;
        told += contains(warmup.calibration.reason, GetParam().reason) ? 1 : 0;
    }
    EXPECT_GE(told, kRecords - 1);
}

constexpr const char* kNoCurve = "does not follow a warm-up curve";
double step(double t_s) { return t_s > 700.0 ? radFromDeg(0.06) : 0.0; }
double swing(double t_s) { return radFromDeg(0.02) * std::sin(t_s / 15.0); }
double secondWarmup(double t_s) { return -radFromDeg(0.3) * std::expm1(-t_s / 40.0); }
double nudge(double t_s) { return t_s > 300.0 && t_s < 300.3 ? radFromDeg(0.5 / 0.3) : 0.0; }
double slowTurn(double t_s) { return t_s > 500.0 && t_s < 620.0 ? radFromDeg(0.05) : 0.0; }
double drive(double t_s) { return t_s > 420.0 ? radFromDeg(20.0) * std::sin(t_s) : 0.0; }
double ramp(double t_s) { return radFromDeg(0.1) * t_s / 1200.0; }

INSTANTIATE_TEST_SUITE_P(
    By, TroubledWarmup,
    testing::Values(Trouble{"Step", {.besides = step}, kNoCurve},
                    Trouble{"Swing", {.besides = swing}, kNoCurve},
                    Trouble{"SecondTime", {.besides = secondWarmup}, kNoCurve},
                    Trouble{"Nudge", {.besides = nudge}, "turned by about"},
                    Trouble{"SlowTurn", {.besides = slowTurn}, kNoCurve},
                    Trouble{"Drive", {.besides = drive}, "turned by about"},
                    Trouble{"Ramp", {.curve = {0.0, 0.01, 300.0}, .besides = ramp}, "straight"}),
    [](const auto& each) { return std::string(each.param.name); });

double warmingRoom(double t_s) { return radFromDeg(0.03) * t_s / 1200.0; }

constexpr WarmupOptions kRoomMayChange{.room = RoomTemperature::kMayChange};

TEST(WarmupCalibration, TellsTheCurveFromARoomThatChanges) {
    const Stand stand{.minutes = 45.0, .besides = warmingRoom};
    const Warmup warmup = warmupOf(stand, 1, {}, kRoomMayChange);
    const Calibration& calibration = warmup.calibration;
    ASSERT_EQ(calibration.verdict, kAccepted) << calibration.reason;
    EXPECT_TRUE(calibration.found[0].now.interval(0.999).contains(kGyrostar.c1_rad_s));
    EXPECT_TRUE(calibration.found[2].now.interval(0.999).contains(kGyrostar.time_s));
    const Estimate room = warmup.fit->room_rad_s2();
    EXPECT_TRUE(room.interval(0.999).contains(radFromDeg(0.03) / 1200.0));
    // gyro_kalman does not know the room: 0.0075 °/s on average over the next ten minutes.
    EXPECT_GT(warmup.cost->curve_rad_s, radFromDeg(0.006));
}

TEST(WarmupCalibration, SaysWhenTheRoomChangesAlthoughItWasToldToBeSteady) {
    int told = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Warmup warmup =
            warmupOf({.minutes = 45.0, .rate_hz = 10.0, .besides = warmingRoom}, seed);
        EXPECT_EQ(warmup.calibration.verdict, kRefused);
        told += contains(warmup.calibration.reason, "Say that its temperature may change") ? 1 : 0;
    }
    EXPECT_GE(told, 9);
}

TEST(WarmupCalibration, SaysThatARoomAloneMightHaveMadeTheDrift) {
    const Stand stand{.curve = {0.0, 0.01, 300.0}, .besides = ramp};
    const Warmup warmup = warmupOf(stand, 1, {}, kRoomMayChange);
    EXPECT_EQ(warmup.calibration.verdict, kRefused);
    EXPECT_TRUE(contains(warmup.calibration.reason, "a changing room alone makes it"))
        << warmup.calibration.reason;
}

TEST(WarmupCalibration, TakesLongerWhereTheRoomMayChange) {
    const Stand stand{.minutes = 22.0};
    EXPECT_TRUE(warmupOf(stand, 4).known);
    const Warmup warmup = warmupOf(stand, 4, {}, kRoomMayChange);
    EXPECT_FALSE(warmup.known);
    ASSERT_TRUE(warmup.known_in_s);
    EXPECT_NEAR(*warmup.known_in_s, 60.0 * 8.0, 60.0 * 6.0);
    EXPECT_TRUE(contains(warmup.calibration.reason, "too early")) << warmup.calibration.reason;
}

// The wheels of a robot that stands, and starts at that time.
void addWheels(std::vector<SensorReport>& reports, double starts_s) {
    for (SensorReport& report : reports) {
        const double t_s = report.robot_time_s;
        report.odometry = WheelTravel{std::max(0.0, t_s - starts_s), std::max(0.0, t_s - starts_s)};
    }
}

TEST(WarmupCalibration, IsRefusedWhereTheWheelsCountTooEarly) {
    Random random(6);
    auto reports = reportsOf({}, random);
    addWheels(reports, 400.0);
    const Warmup warmup = calibrateWarmup(reports, {});
    EXPECT_EQ(warmup.calibration.verdict, kRefused);
    EXPECT_TRUE(contains(warmup.calibration.reason, "The wheels moved."));
    EXPECT_NEAR(warmup.stood_s, 399.0, 1.0);
}

TEST(WarmupCalibration, SaysHowLongItTakesWhereItWasDisturbed) {
    Random random(6);
    auto reports = reportsOf({}, random);
    addWheels(reports, 600.0);
    const std::string reason = calibrateWarmup(reports, {}).calibration.reason;
    EXPECT_TRUE(contains(reason, "cold")) << reason;
    EXPECT_TRUE(contains(reason, "min in all.")) << reason;
}

TEST(WarmupCalibration, CountsWhatCameBeforeADrive) {
    Random random(7);
    auto reports = reportsOf({.minutes = 30.0}, random);
    addWheels(reports, 1500.0);
    const Warmup warmup = calibrateWarmup(reports, {});
    EXPECT_EQ(warmup.calibration.verdict, kAccepted) << warmup.calibration.reason;
    EXPECT_TRUE(contains(warmup.calibration.remarks.front(), "After 25 min"))
        << warmup.calibration.remarks.front();
}

TEST(WarmupCalibration, IsRefusedWithoutReadings) {
    EXPECT_TRUE(contains(calibrateWarmup({}, {}).calibration.reason, "No gyro readings"));
    const Warmup few = warmupOf({.minutes = 0.3});
    EXPECT_TRUE(contains(few.calibration.reason, "not stood for long"));
    EXPECT_FALSE(few.calibration.steps.empty());
}

TEST(WarmupCalibration, IsRefusedWhereTheReadingsAreNoGood) {
    Random random(8);
    const auto reports = reportsOf({.minutes = 5.0}, random);
    auto equal = reports;
    auto no_numbers = reports;
    auto clipped = reports;
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const double rate = std::get<GyroRate>(reports[i].gyro).rad_s;
        equal[i].gyro = GyroRate{0.01};
        clipped[i].gyro = GyroRate{std::min(rate, radFromDeg(-0.2))};
        if (i % 3 == 0) no_numbers[i].gyro = GyroRate{std::nan("")};
        if (i % 7 == 0) no_numbers[i].robot_time_s = std::numeric_limits<double>::infinity();
    }
    EXPECT_TRUE(contains(calibrateWarmup(equal, {}).calibration.reason, "equal"));
    EXPECT_TRUE(contains(calibrateWarmup(no_numbers, {}).calibration.reason, "no numbers"));
    EXPECT_TRUE(contains(calibrateWarmup(clipped, {}).calibration.reason, "end of its range"));
}

TEST(WarmupCalibration, IsRefusedWhereTheReadingsAreBeyondReason) {
    for (const double size : {1e200, 1e308}) {
        for (const RoomTemperature room : {RoomTemperature::kSteady, RoomTemperature::kMayChange}) {
            Random random(8);
            auto reports = reportsOf({.minutes = 5.0, .rate_hz = 10.0}, random);
            for (SensorReport& report : reports) report.gyro = GyroRate{size * random.normal()};
            const Warmup warmup = calibrateWarmup(reports, {}, {.room = room});
            EXPECT_EQ(warmup.calibration.verdict, kRefused);
            EXPECT_FALSE(warmup.calibration.reason.empty());
        }
    }
}

TEST(WarmupCalibration, TakesLoneBrokenReadingsAndGaps) {
    Random random(9);
    auto reports = reportsOf({.minutes = 25.0}, random);
    for (std::size_t i = 100; i < reports.size(); i += 997) reports[i].gyro = GyroRate{3.0};
    reports.erase(reports.begin() + 8000, reports.begin() + 12000);
    const Warmup warmup = calibrateWarmup(reports, {});
    ASSERT_EQ(warmup.calibration.verdict, kAccepted) << warmup.calibration.reason;
    EXPECT_TRUE(warmup.fit->time_s().interval(0.999).contains(kGyrostar.time_s));
}

TEST(WarmupCalibration, LeavesACurveThatIsAsGood) {
    Vehicle believed;
    believed.gyro_drift = kGyrostar;
    int unchanged = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Verdict verdict = warmupOf({.rate_hz = 10.0}, seed, believed).calibration.verdict;
        EXPECT_NE(verdict, kAccepted);
        unchanged += verdict == Verdict::kUnchanged ? 1 : 0;
    }
    EXPECT_GE(unchanged, 7);
}

}  // namespace
}  // namespace hedr
