#include "core/calibration/squares/square_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "core/simulation/umbmark_squares.h"
#include "core/simulation/wheels.h"
#include "tests/core/calibration/squares/square_drives.h"

namespace hedr {
namespace {

constexpr double kRight_rad = -0.5 * kPi;
constexpr double kLeft_rad = 0.5 * kPi;

// A perfect robot that is told where to go.
class Log {
  public:
    explicit Log(double rate_hz = 4.0) : rate_hz_(rate_hz) { stand(5.0); }

    void stand(double seconds) {
        for (int i = 0; i < seconds * rate_hz_; ++i) note();
    }
    void straight(double way_m) { go(way_m, 0.0, std::abs(way_m) / 0.2); }
    void turn(double rad) { go(0.0, rad, std::abs(rad) / 0.3); }
    void square(double side_m, double corner_rad) {
        for (int i = 0; i < 4; ++i) {
            straight(side_m);
            turn(corner_rad);
        }
        stand(5.0);
    }
    std::vector<SampleSet> sets() const { return {{"log", reports}}; }

    std::vector<SensorReport> reports{};

  private:
    void go(double way_m, double turn_rad, double seconds) {
        const int steps = static_cast<int>(std::ceil(seconds * rate_hz_));
        const double half_turn_m = 0.5 * turn_rad * kLabmate.wheelbase_m;
        for (int i = 0; i < steps; ++i) {
            left_m_ += (way_m - half_turn_m) / steps;
            right_m_ += (way_m + half_turn_m) / steps;
            note();
        }
    }
    void note() {
        time_s_ += 1.0 / rate_hz_;
        reports.push_back(
            {.robot_time_s = time_s_, .odometry = wheelCounts(kLabmate, left_m_, right_m_)});
    }

    double rate_hz_;
    double time_s_ = 0.0;
    double left_m_ = 0.0;
    double right_m_ = 0.0;
};

SquareRuns runsIn(const Log& log) { return squareRunsOf(log.sets(), labmate()); }

// A good square, the run in question, a good square.
template <class Run>
SquareRuns runsWith(Run run) {
    Log log;
    log.square(2.0, kLeft_rad);
    run(log);
    log.stand(5.0);
    log.square(2.0, kLeft_rad);
    return runsIn(log);
}

void expectSecondIsLeftOut(const SquareRuns& found, const std::string& reason) {
    ASSERT_EQ(found.runs.size(), 2U);
    EXPECT_EQ(found.runs[0].number, 1U);
    EXPECT_EQ(found.runs[1].number, 3U);
    ASSERT_EQ(found.left_out.size(), 1U);
    EXPECT_EQ(found.left_out[0].number, 2U);
    EXPECT_EQ(found.left_out[0].reason, reason);
}

TEST(SquareRuns, AreCutOutOfALogAndToldApartByTheirTurning) {
    const SimulatedMission mission = simulate(UmbmarkSquares{}, 3);
    const std::vector<SampleSet> sets{{"simulated", mission.sensors}};
    const SquareRuns found = squareRunsOf(sets, mission.vehicle);
    ASSERT_EQ(found.runs.size(), 10U);
    EXPECT_TRUE(found.left_out.empty());
    EXPECT_EQ(found.moves, 0U);
    EXPECT_FALSE(found.unfinished);
    for (std::size_t i = 0; i < 10; ++i) {
        const SquareRun& run = found.runs[i];
        EXPECT_EQ(run.number, i + 1);
        EXPECT_EQ(run.turning, i < 5 ? Turning::kClockwise : Turning::kCounterClockwise);
        EXPECT_NEAR(run.side_m, 4.0, 0.02);
        EXPECT_NEAR(run.corner_rad, 0.5 * kPi, 0.05);
        EXPECT_EQ(mission.truth[run.first].pose, mission.truth[run.first + 1].pose);
        EXPECT_EQ(mission.truth[run.last].pose, mission.truth[run.last - 1].pose);
    }
}

TEST(SquareRuns, KeepEveryCountOfTheEncoders) {
    Log log(20.0);
    log.square(2.0, kLeft_rad);
    const SquareRuns found = runsIn(log);
    ASSERT_EQ(found.runs.size(), 1U);
    WheelTravel sum;
    for (const WheelTravel& step : found.runs[0].steps) {
        sum.left_m += step.left_m;
        sum.right_m += step.right_m;
    }
    const double turned_m = 2.0 * kPi * kLabmate.wheelbase_m;
    EXPECT_NEAR(sum.right_m - sum.left_m, turned_m, 0.001);
    EXPECT_NEAR(sum.right_m + sum.left_m, 16.0, 0.001);
}

TEST(SquareRuns, AreCountedOverSeveralLogs) {
    Log one;
    one.square(2.0, kRight_rad);
    Log two;
    two.square(2.0, kLeft_rad);
    two.square(2.0, kLeft_rad);
    const std::vector<SampleSet> sets{{"a", one.reports}, {"b", two.reports}};
    const SquareRuns found = squareRunsOf(sets, labmate());
    ASSERT_EQ(found.runs.size(), 3U);
    EXPECT_EQ(found.runs[0].set, 0U);
    EXPECT_EQ(found.runs[0].turning, Turning::kClockwise);
    EXPECT_EQ(found.runs[2].set, 1U);
    EXPECT_EQ(found.runs[2].number, 3U);
}

TEST(SquareRuns, HaveTheNumbersOfTheirLogsThoughOneHasNoSquare) {
    Log good;
    good.square(2.0, kLeft_rad);
    Log broken_off;
    broken_off.straight(1.0);
    const std::vector<SampleSet> sets{
        {"a", good.reports}, {"b", broken_off.reports}, {"c", good.reports}};
    const SquareRuns found = squareRunsOf(sets, labmate());
    ASSERT_EQ(found.runs.size(), 2U);
    EXPECT_EQ(found.runs[1].number, 3U);
    ASSERT_EQ(found.left_out.size(), 1U);
    EXPECT_EQ(found.left_out[0].number, 2U);
    EXPECT_EQ(found.left_out[0].reason, "has no whole square in its log");
    EXPECT_FALSE(found.unfinished);
}

TEST(SquareRuns, OfAMissionAreNotCountedWhereARobotWasOnlyStarted) {
    Log good;
    good.square(2.0, kLeft_rad);
    const Log standing;
    const std::vector<SampleSet> sets{{"m.hedr", standing.reports}, {"m.hedr", good.reports}};
    const SquareRuns found = squareRunsOf(sets, labmate());
    ASSERT_EQ(found.runs.size(), 1U);
    EXPECT_EQ(found.runs[0].number, 1U);
}

// A tracked robot's wheelbase may be believed a third too small: it seems to turn by 121°.
TEST(SquareRuns, AreKnownThoughTheWheelbaseIsBelievedAThirdTooSmall) {
    Log log;
    log.square(2.0, 1.35 * kLeft_rad);
    EXPECT_EQ(runsIn(log).runs.size(), 1U);
}

TEST(SquareRuns, NeedNoTurnAfterTheLastSide) {
    const SquareRuns found = runsWith([](Log& log) {
        for (int i = 0; i < 3; ++i) {
            log.straight(2.0);
            log.turn(kRight_rad);
        }
        log.straight(2.0);
    });
    ASSERT_EQ(found.runs.size(), 3U);
    EXPECT_EQ(found.runs[1].turning, Turning::kClockwise);
}

TEST(SquareRuns, MayBeSteeredAndRoundTheirCorners) {
    Log log;
    for (int corner = 0; corner < 4; ++corner) {
        for (int i = 0; i < 10; ++i) {
            log.straight(0.2);
            log.turn(i % 2 == 0 ? 0.05 : -0.05);
        }
        for (int i = 0; i < 9; ++i) {
            log.straight(0.01);
            log.turn(kLeft_rad / 9.0);
        }
    }
    log.stand(5.0);
    const SquareRuns found = runsIn(log);
    ASSERT_EQ(found.runs.size(), 1U);
    EXPECT_NEAR(found.runs[0].corner_rad, 0.5 * kPi, 0.15);
}

TEST(SquareRuns, LeaveOutWhatHasThreeSides) {
    expectSecondIsLeftOut(runsWith([](Log& log) {
                              for (int i = 0; i < 3; ++i) {
                                  log.straight(2.0);
                                  log.turn(kLeft_rad);
                              }
                          }),
                          "has 3 sides where a square has four");
}

TEST(SquareRuns, LeaveOutWhatTurnedBothWays) {
    expectSecondIsLeftOut(runsWith([](Log& log) {
                              for (const double sign : {1.0, 1.0, -1.0, 1.0}) {
                                  log.straight(2.0);
                                  log.turn(sign * kLeft_rad);
                              }
                          }),
                          "turned both ways");
}

TEST(SquareRuns, LeaveOutWhatIsNotClosed) {
    expectSecondIsLeftOut(runsWith([](Log& log) {
                              for (const double side_m : {2.0, 2.0, 1.0, 2.0}) {
                                  log.straight(side_m);
                                  log.turn(kLeft_rad);
                              }
                          }),
                          "is not closed: opposite sides of it are 2 m and 1 m long");
}

TEST(SquareRuns, LeaveOutAnotherSize) {
    const SquareRuns found = runsWith([](Log& log) { log.square(1.0, kLeft_rad); });
    expectSecondIsLeftOut(found, "has sides of 1 m where others have 2 m");
}

TEST(SquareRuns, LeaveOutWhatWasBrokenByARestart) {
    Log log;
    log.square(2.0, kLeft_rad);
    const std::size_t before = log.reports.size();
    log.square(2.0, kLeft_rad);
    const std::size_t after = log.reports.size();
    log.square(2.0, kLeft_rad);
    const std::size_t middle = (before + after) / 2;
    for (std::size_t i = middle; i < log.reports.size(); ++i) {
        log.reports[i].robot_time_s -= 100.0;
        std::get<WheelTicks>(log.reports[i].odometry).left -= 1000000;
    }
    expectSecondIsLeftOut(runsIn(log), "was broken: the robot started again in it");
}

TEST(SquareRuns, LeaveOutWhereReportsAreMissing) {
    Log log;
    log.square(2.0, kLeft_rad);
    const auto before = static_cast<std::ptrdiff_t>(log.reports.size());
    log.square(2.0, kLeft_rad);
    log.square(2.0, kLeft_rad);
    // From the middle of the first side to the second one.
    log.reports.erase(log.reports.begin() + before + 20, log.reports.begin() + before + 75);
    expectSecondIsLeftOut(runsIn(log), "cannot be followed: reports are missing in it");
}

TEST(SquareRuns, DoNotCountMovesToTheStart) {
    const SquareRuns found = runsWith([](Log& log) {
        log.straight(0.3);
        log.turn(0.6);
    });
    EXPECT_EQ(found.moves, 1U);
    ASSERT_EQ(found.runs.size(), 2U);
    EXPECT_EQ(found.runs[1].number, 2U);
    EXPECT_TRUE(found.left_out.empty());
}

TEST(SquareRuns, TellThatTheLastOneIsNotFinished) {
    Log log;
    log.square(2.0, kLeft_rad);
    log.straight(2.0);
    log.turn(kLeft_rad);
    log.straight(1.0);
    const SquareRuns found = runsIn(log);
    EXPECT_TRUE(found.unfinished);
    EXPECT_EQ(found.runs.size(), 1U);
    EXPECT_TRUE(found.left_out.empty());
}

TEST(SquareRuns, EndWhereALogEndsRightAfterTheSquare) {
    Log log;
    for (int i = 0; i < 4; ++i) {
        log.straight(2.0);
        log.turn(kLeft_rad);
    }
    const SquareRuns found = runsIn(log);
    EXPECT_FALSE(found.unfinished);
    EXPECT_EQ(found.runs.size(), 1U);
}

TEST(SquareRuns, EndThoughAnEncoderFlickersAtACount) {
    Log log(20.0);
    log.square(2.0, kLeft_rad);
    log.square(2.0, kRight_rad);
    for (std::size_t i = 0; i < log.reports.size(); i += 2)
        ++std::get<WheelTicks>(log.reports[i].odometry).left;
    EXPECT_EQ(runsIn(log).runs.size(), 2U);
}

TEST(SquareRuns, PassOverReportsThatAreNoNumbers) {
    Log log;
    log.square(2.0, kLeft_rad);
    for (std::size_t i = 3; i < log.reports.size(); i += 7) {
        log.reports[i].robot_time_s = std::numeric_limits<double>::quiet_NaN();
    }
    EXPECT_EQ(runsIn(log).runs.size(), 1U);
}

TEST(SquareRuns, NeedWheelsThatAreToldApart) {
    Log log;
    log.square(2.0, kLeft_rad);
    for (SensorReport& report : log.reports) report.odometry = PathTravel{report.robot_time_s};
    const SquareRuns found = runsIn(log);
    EXPECT_FALSE(found.wheels_told_apart);
    EXPECT_TRUE(found.runs.empty());
}

TEST(SquareRuns, OfNothingAreNone) {
    const SquareRuns found = squareRunsOf({}, labmate());
    EXPECT_TRUE(found.runs.empty());
    EXPECT_TRUE(found.wheels_told_apart);
    EXPECT_FALSE(found.unfinished);
}

}  // namespace
}  // namespace hedr
