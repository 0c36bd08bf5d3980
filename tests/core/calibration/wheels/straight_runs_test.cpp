#include "core/calibration/wheels/straight_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "core/simulation/wheels.h"

namespace hedr {
namespace {

struct RunBench {
    double scale = 1.01;  // real over believed diameter
    double distance_m = 10.0;
    double mark_m = 0.005;
    int runs = 6;
    bool bent = false;  // the first one
    bool one_log = true;
};

Vehicle believedOnRuns() {
    return {.geometry = {.left_wheel_diameter_m = 0.15,
                         .right_wheel_diameter_m = 0.15,
                         .wheelbase_m = 0.34,
                         .ticks_per_revolution = 2000.0}};
}

std::vector<SampleSet> runsOf(const RunBench& bench, std::uint64_t seed) {
    Random random(seed);
    VehicleGeometry real = believedOnRuns().geometry;
    real.left_wheel_diameter_m *= bench.scale;
    real.right_wheel_diameter_m *= bench.scale;
    real.wheelbase_m *= bench.scale;
    Wheels wheels(real, 1e-3);
    std::vector<SampleSet> sets(bench.one_log ? 1 : static_cast<std::size_t>(bench.runs));
    for (int run = 0; run < bench.runs; ++run) {
        auto& reports = sets[bench.one_log ? 0 : static_cast<std::size_t>(run)].reports;
        const double way_m =
            (run % 2 == 0 ? 1.0 : -1.0) * (bench.distance_m + bench.mark_m * random.normal());
        const auto step = [&](double step_m, double turn_rad) {
            wheels.move(step_m, turn_rad, random);
            reports.push_back({.robot_time_s = 0.05 * static_cast<double>(reports.size()),
                               .odometry = wheels.ticks()});
        };
        for (int i = 0; i < 80; ++i) step(0.0, 0.0);
        for (int i = 0; i < 400; ++i) step(way_m / 400, run == 0 && bench.bent ? 0.002 : 0.0);
        for (int i = 0; i < 80; ++i) step(0.0, 0.0);
    }
    return sets;
}

StraightRuns foundBy(const RunBench& bench, std::uint64_t seed) {
    return calibrateByStraightRuns(runsOf(bench, seed), believedOnRuns(), bench.distance_m);
}

TEST(StraightRuns, FindTheSizeOfTheWheels) {
    for (const bool one_log : {true, false}) {
        const StraightRuns straight = foundBy({.one_log = one_log}, 1);
        EXPECT_EQ(straight.calibration.verdict, Verdict::kAccepted) << straight.calibration.reason;
        ASSERT_EQ(straight.runs.size(), 6U);
        EXPECT_NEAR(straight.calibration.found[0].now.value, 0.15 * 1.01, 0.15 * 0.001);
        EXPECT_NEAR(straight.calibration.found[2].now.value, 0.34 * 1.01, 0.34 * 0.001);
    }
}

// Nothing is known of a wheelbase from them but that it turns as before.
TEST(StraightRuns, LetTheWheelbaseFollowTheWheels) {
    const auto found = foundBy({}, 1).calibration.found;
    EXPECT_FALSE(found[0].follows || found[1].follows);
    EXPECT_TRUE(found[2].follows);
    EXPECT_DOUBLE_EQ(found[2].now.value / 0.34, found[0].now.value / 0.15);
}

// As of a robot that was restarted between them.
TEST(StraightRuns, MayLieInSeveralLogs) {
    std::vector<SampleSet> sets = runsOf({.runs = 4}, 1);
    sets.push_back(runsOf({.runs = 4}, 2).front());
    const StraightRuns straight = calibrateByStraightRuns(sets, believedOnRuns(), 10.0);
    EXPECT_EQ(straight.runs.size(), 8U);
    EXPECT_EQ(straight.runs.back().number, 8U);
    EXPECT_TRUE(straight.calibration.remarks.empty());
}

TEST(StraightRuns, AreUnbiasedAndHonest) {
    constexpr int kRuns = 1000;
    int covered = 0;
    double sum = 0.0, squares = 0.0;
    for (int run = 0; run < kRuns; ++run) {
        const Estimate left =
            foundBy({}, static_cast<std::uint64_t>(run) + 1).calibration.found[0].now;
        covered += left.interval().contains(0.15 * 1.01) ? 1 : 0;
        sum += (left.value - 0.15 * 1.01) / kRuns;
        squares += std::pow(left.value - 0.15 * 1.01, 2) / kRuns;
    }
    std::printf("covered %.1f %%, mean error %.2f sigma\n", 100.0 * covered / kRuns,
                std::abs(sum) / std::sqrt(squares));
    EXPECT_GT(covered, 930);
    EXPECT_LT(covered, 970);
    EXPECT_LT(std::abs(sum), 0.2 * std::sqrt(squares));
}

TEST(StraightRuns, ThatAreBentOrTooShortAreNamedAndLeftOut) {
    const StraightRuns straight = foundBy({.bent = true}, 1);
    EXPECT_EQ(straight.runs.size(), 5U);
    ASSERT_FALSE(straight.calibration.remarks.empty());
    EXPECT_EQ(straight.calibration.remarks[0], "Run 1 was left out: it was not straight.");
    const auto sets = runsOf({.distance_m = 2.0, .one_log = false}, 1);
    const StraightRuns other = calibrateByStraightRuns(sets, believedOnRuns(), 10.0);
    EXPECT_EQ(other.calibration.verdict, Verdict::kRefused);
    EXPECT_EQ(other.calibration.reason, "Two straight runs of 10 m are the least; 0 can be used.");
    EXPECT_EQ(other.calibration.remarks[0], "Run 1 was left out: by the wheels it went 1.98 m.");
}

TEST(StraightRuns, AreRefusedWithTheReason) {
    EXPECT_NE(calibrateByStraightRuns({}, believedOnRuns(), 10.0)
                  .calibration.reason.find("No encoder counts"),
              std::string::npos);
    for (const double length_m : {0.0, -1.0, std::nan("")}) {
        EXPECT_EQ(
            calibrateByStraightRuns(runsOf({}, 1), believedOnRuns(), length_m).calibration.reason,
            "The length of the runs has to be more than nothing.");
    }
}

TEST(StraightRuns, LeaveRightWheelsAlone) {
    EXPECT_NE(foundBy({.scale = 1.0}, 3).calibration.verdict, Verdict::kAccepted);
}

}  // namespace
}  // namespace hedr
