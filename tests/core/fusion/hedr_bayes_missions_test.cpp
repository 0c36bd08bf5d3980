#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/fusion/hedr_bayes.h"
#include "core/robot/motion.h"
#include "core/simulation/scenario.h"
#include "core/track/evaluation.h"

namespace hedr {
namespace {

// Out of the hall, and a minute of corridors.
constexpr double kBackInCorridors_s = 120.0;

struct Outcome {
    Evaluation evaluation{};
    double squared_error_at_900_s = 0.0;  // e' P^-1 e
    double lost_s = 0.0;
    double heading_after_task_deg = 0.0;  // rms
};

Outcome outcomeOf(const SimulatedMission& mission) {
    HedrBayes filter(mission.start, hedrBayesPreset(mission.vehicle));
    MotionBuilder motions(mission.vehicle);
    std::vector<TrackPoint> track;
    Outcome run;
    double squares_after = 0.0;
    double after = 0.0;
    for (std::size_t i = 0; i < mission.sensors.size(); ++i) {
        const auto motion = motions.add(mission.sensors[i]);
        if (motion) filter.update(*motion);
        const double t_s = motions.time_s();
        track.push_back({t_s, filter.pose()});
        if (filter.status().lost) run.lost_s += 0.02;
        const Pose<World>& truth = mission.truth[i].pose;
        const double heading_error = wrapAngle(filter.pose().heading_rad - truth.heading_rad);
        if (mission.task_end_s > 0.0 && t_s > mission.task_end_s + kBackInCorridors_s) {
            squares_after += heading_error * heading_error;
            after += 1.0;
        }
        if (i != 45000) continue;
        const Vector<World> apart = filter.pose().position - truth.position;
        const Eigen::Vector3d error(apart.x, apart.y, heading_error);
        run.squared_error_at_900_s = error.dot(filter.covariance().inverse() * error);
    }
    if (after > 0.0) run.heading_after_task_deg = degFromRad(std::sqrt(squares_after / after));
    run.evaluation = evaluate(track, mission.truth, Alignment::kStart).value();
    return run;
}

std::vector<Outcome> runsOf(std::string_view scenario_name, double bias_walk_deg = 0.004) {
    Scenario scenario = scenarioByName(scenario_name).value();
    EXPECT_TRUE(
        setScenarioValue(scenario, "gyro_bias_walk_deg_s_sqrts", std::to_string(bias_walk_deg)));
    std::vector<Outcome> runs;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        runs.push_back(outcomeOf(simulate(scenario, seed)));
    return runs;
}

template <class Value>
std::vector<double> sorted(const std::vector<Outcome>& runs, Value value) {
    std::vector<double> values;
    for (const Outcome& run : runs) values.push_back(value(run));
    std::sort(values.begin(), values.end());
    return values;
}

double headingRms(const Outcome& run) { return run.evaluation.heading_rmse_deg; }

void expectHeading(const std::vector<Outcome>& runs, double median_deg, double worst_deg) {
    const auto rms = sorted(runs, headingRms);
    EXPECT_LE(0.5 * (rms[9] + rms[10]), median_deg);
    EXPECT_LE(rms.back(), worst_deg);
    std::printf("heading rms: median %.2f, worst %.2f deg\n", 0.5 * (rms[9] + rms[10]), rms.back());
}

TEST(HedrBayesOnSimulatedPackbots, KeepsTheHeadingInCorridors) {
    const auto runs = runsOf("packbot-corridors");
    expectHeading(runs, 0.6, 0.9);
    for (const Outcome& run : runs) {
        EXPECT_LT(run.evaluation.end_position_error_m, 0.003 * run.evaluation.distance_m);
        EXPECT_EQ(run.lost_s, 0.0);
    }
}

TEST(HedrBayesOnSimulatedPackbots, KeepsTheHeadingWithAVeryBadGyro) {
    expectHeading(runsOf("packbot-corridors", 0.02), 1.2, 2.0);
}

TEST(HedrBayesOnSimulatedPackbots, CrossesAHall) {
    expectHeading(runsOf("packbot-hall"), 0.8, 1.5);
}

TEST(HedrBayesOnSimulatedPackbots, KnowsDiagonalWings) {
    expectHeading(runsOf("packbot-45"), 1.0, 1.0);
}

// What it gets wrong about a building that it has to find first stays wrong.
TEST(HedrBayesOnSimulatedPackbots, FindsABuildingThatIsNotParallelToTheStart) {
    expectHeading(runsOf("packbot-offset"), 1.0, 2.0);
}

TEST(HedrBayesOnSimulatedPackbots, ComesBackAfterPushingABox) {
    const auto runs = runsOf("packbot-box");
    expectHeading(runs, 2.5, 6.0);
    const auto after = sorted(runs, [](const Outcome& run) { return run.heading_after_task_deg; });
    for (const double deg : after) std::printf("%.1f ", deg);
    std::printf("deg: rms of each run from a minute in the corridors on\n");
    EXPECT_LE(after[18], 2.0);
    for (const Outcome& run : runs) {
        const bool announced = run.lost_s > 0.0;
        EXPECT_TRUE(announced || run.evaluation.heading_max_deg < 10.0);
    }
}

// The errors must be as large as the filter says, within a factor of two. One instant of each
// mission: the sum of the squares is then a chi square of 300 degrees of freedom, whose 95 % lie
// between 254 and 350.
TEST(HedrBayesOnSimulatedPackbots, KnowsHowFarItIsOff) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
        sum += outcomeOf(simulate(scenarioByName("packbot-corridors").value(), seed))
                   .squared_error_at_900_s;
    std::printf("normalised squared error: %.2f per dimension\n", sum / 300.0);
    EXPECT_GT(sum, 0.5 * 254.0);
    EXPECT_LT(sum, 2.0 * 350.0);
}

}  // namespace
}  // namespace hedr
