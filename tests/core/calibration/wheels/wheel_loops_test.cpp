#include "core/calibration/wheels/wheel_loops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/geometry/angle.h"
#include "tests/core/calibration/wheels/loop_bench.h"

namespace hedr {
namespace {

using test::believedRobot;
using test::LoopBench;
using test::LoopDrive;
using test::loopsOf;

WheelLoops found(const LoopBench& bench, std::uint64_t seed) {
    return calibrateByLoops(loopsOf(bench, seed), believedRobot());
}

TEST(WheelLoops, FindWhatTheWheelsAre) {
    const WheelLoops wheels = found({}, 1);
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kAccepted) << wheels.calibration.reason;
    EXPECT_NEAR(wheels.shape.wheelbase_m, 0.34 * 1.03, 0.34 * 0.005);
    EXPECT_NEAR(wheels.shape.right_larger, 0.01, 0.0005);
    EXPECT_GT(wheels.calibration.proof->times_better, 5.0);
}

struct LoopCoverage {
    double wheelbase = 0.0;
    double ratio = 0.0;
    double bias_sigmas = 0.0;
    int worse = 0;
};

LoopCoverage coverageOf(const LoopBench& bench, int runs) {
    LoopCoverage coverage;
    double sum = 0.0, squares = 0.0;
    for (int run = 0; run < runs; ++run) {
        const WheelLoops wheels = found(bench, static_cast<std::uint64_t>(run) + 1);
        if (wheels.calibration.found.empty()) continue;
        const Estimate& base = wheels.calibration.found[0].now;
        const Estimate& right = wheels.calibration.found[2].now;
        const double base_m = 0.34 * bench.wheelbase_ratio;
        const double right_m = 0.15 * (1.0 + 0.5 * bench.right_larger);
        coverage.wheelbase += base.interval().contains(base_m) ? 1.0 / runs : 0.0;
        coverage.ratio += right.interval().contains(right_m) ? 1.0 / runs : 0.0;
        sum += (base.value - base_m) / runs;
        squares += std::pow(base.value - base_m, 2) / runs;
    }
    coverage.bias_sigmas = std::abs(sum) / std::sqrt(squares - sum * sum);
    std::printf("covered: wheelbase %.1f %%, ratio %.1f %%; mean error %.2f sigma, sigma %.5f m\n",
                100.0 * coverage.wheelbase, 100.0 * coverage.ratio, coverage.bias_sigmas,
                std::sqrt(squares));
    return coverage;
}

TEST(WheelLoops, DISABLED_AreUnbiasedAndHonest) {
    for (const LoopBench& bench :
         {LoopBench{}, LoopBench{.each_way = 2}, LoopBench{.each_way = 12},
          LoopBench{.right_larger = -0.02, .wheelbase_ratio = 0.95, .mark_m = 0.03}}) {
        const LoopCoverage coverage = coverageOf(bench, 1000);
        EXPECT_GT(coverage.wheelbase, 0.93);
        EXPECT_LT(coverage.wheelbase, 0.97);
        EXPECT_GT(coverage.ratio, 0.93);
        EXPECT_LT(coverage.ratio, 0.97);
        EXPECT_LT(coverage.bias_sigmas, 0.2);
    }
}

// How many were accepted and have a value that is truly further off than it was.
int worseLoops(int calibrations) {
    Random random(31);
    int accepted = 0;
    int worse = 0;
    for (int i = 0; i < calibrations; ++i) {
        LoopBench bench{.each_way = 1 + static_cast<int>(random.uniform(0.0, 8.0))};
        bench.right_larger = random.uniform() < 0.3 ? 0.0 : 0.005 * random.normal();
        bench.wheelbase_ratio = random.uniform() < 0.3 ? 1.0 : 1.0 + 0.01 * random.normal();
        bench.mark_m = random.uniform(0.002, 0.05);
        bench.mark_rad = radFromDeg(random.uniform(0.2, 4.0));
        bench.unevenness_m_sqrtm = random.uniform(1e-4, 4e-3);
        auto sets = loopsOf(bench, static_cast<std::uint64_t>(i) + 1);
        // One that was not driven to its end.
        if (random.uniform() < 0.3) {
            auto& reports = sets[0].reports;
            reports.resize(static_cast<std::size_t>(random.uniform(0.7, 1.0) *
                                                    static_cast<double>(reports.size())));
        }
        const WheelLoops wheels = calibrateByLoops(sets, believedRobot());
        if (wheels.calibration.verdict != Verdict::kAccepted) continue;
        ++accepted;
        const double base_after = std::abs(wheels.shape.wheelbase_m / 0.34 - bench.wheelbase_ratio);
        const double right_after = std::abs(wheels.shape.right_larger - bench.right_larger);
        // The heading that is lost in a loop of 20 m: by both of them.
        const double before =
            std::hypot(2.0 * kPi * (bench.wheelbase_ratio - 1.0), 20.0 / 0.34 * bench.right_larger);
        const double after = std::hypot(2.0 * kPi * base_after, 20.0 / 0.34 * right_after);
        worse += after > before ? 1 : 0;
    }
    std::printf("accepted %d of %d, worse %d\n", accepted, calibrations, worse);
    EXPECT_GT(accepted, calibrations / 20);
    return worse;
}

TEST(WheelLoops, NeverMakeAcceptAWorseOne) { EXPECT_EQ(worseLoops(100), 0); }
TEST(WheelLoops, DISABLED_NeverMakeAcceptAWorseOneInAThousand) { EXPECT_EQ(worseLoops(1000), 0); }

TEST(WheelLoops, LeaveRightWheelsAlone) {
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const WheelLoops wheels = found({.right_larger = 0.0, .wheelbase_ratio = 1.0}, seed);
        accepted += wheels.calibration.verdict == Verdict::kAccepted ? 1 : 0;
    }
    EXPECT_EQ(accepted, 0);
}

// By the believed wheels it would be half a turn less.
TEST(WheelLoops, AreCountedByTheGyroWhereTheWheelbaseIsFarOff) {
    const WheelLoops wheels = found({.wheelbase_ratio = 1.5, .gyro = true}, 1);
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kAccepted) << wheels.calibration.reason;
    EXPECT_NEAR(wheels.shape.wheelbase_m, 0.51, 0.005);
}

// Nor is it asked where nobody knows its bias: it would count turns that never were.
TEST(WheelLoops, NeedNoGyro) {
    auto sets = loopsOf({.gyro = true}, 1);
    for (SampleSet& set : sets) {
        constexpr std::ptrdiff_t kStands = 58;  // the vehicle file says no bias, and no stand does
        set.reports.erase(set.reports.begin(), set.reports.begin() + kStands);
        set.reports.erase(set.reports.end() - kStands, set.reports.end());
        for (SensorReport& report : set.reports)
            std::get<GyroRate>(report.gyro).rad_s += radFromDeg(1.5);
    }
    const WheelLoops wheels = calibrateByLoops(sets, believedRobot());
    EXPECT_EQ(wheels.calibration.verdict, Verdict::kAccepted) << wheels.calibration.reason;
    EXPECT_NEAR(wheels.shape.wheelbase_m, 0.34 * 1.03, 0.005);
}

TEST(WheelLoops, AreRefusedWithTheReason) {
    EXPECT_NE(found({.both_ways = false}, 1).calibration.reason.find("same way round"),
              std::string::npos);
    EXPECT_EQ(found({.each_way = 1}, 1).calibration.verdict, Verdict::kRefused);
    EXPECT_NE(found({.each_way = 1}, 1).calibration.reason.find("Four closed drives"),
              std::string::npos);
    EXPECT_EQ(calibrateByLoops({}, believedRobot()).calibration.verdict, Verdict::kRefused);
    auto sets = loopsOf({}, 1);
    for (SensorReport& report : sets[3].reports) report.odometry = PathTravel{};
    EXPECT_NE(calibrateByLoops(sets, believedRobot()).calibration.reason.find("left side"),
              std::string::npos);
}

TEST(WheelLoops, ThatDidNotEndAsTheyBeganAreNamedAndLeftOut) {
    auto sets = loopsOf({}, 1);
    sets[2].reports.resize(sets[2].reports.size() / 2);
    const WheelLoops wheels = calibrateByLoops(sets, believedRobot());
    EXPECT_EQ(wheels.loops.size(), 9U);
    ASSERT_FALSE(wheels.calibration.remarks.empty());
    EXPECT_EQ(wheels.calibration.remarks[0],
              "Drive 3 was left out: it did not end heading as it began.");
}

}  // namespace
}  // namespace hedr
