#include "core/fusion/hedr_bayes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "core/fusion/estimators.h"
#include "core/simulation/scenario.h"
#include "core/track/evaluation.h"
#include "core/track/track_file.h"

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

class HedrBayesDriving : public ::testing::Test {
  protected:
    // Straight at 0.5 m/s, 50 Hz, with a gyro that drifts by `drift_deg_s`.
    void drive(double seconds, double drift_deg_s, double turn_deg_s = 0.0) {
        for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i) {
            t_s_ += 0.02;
            heading_rad_ += radFromDeg(turn_deg_s) * 0.02;
            filter_.update({.t_s = t_s_,
                            .dt_s = 0.02,
                            .distance_m = 0.01,
                            .gyro_turn_rad = radFromDeg(turn_deg_s + drift_deg_s) * 0.02});
        }
    }
    double errorDeg() const { return degFromRad(filter_.pose().heading_rad - heading_rad_); }

    HedrBayes filter_{{}, {}};
    double t_s_ = 0.0;
    double heading_rad_ = 0.0;
};

TEST_F(HedrBayesDriving, FindsTheDriftOfAStraightDrive) {
    drive(120.0, 0.05);
    EXPECT_NEAR(errorDeg(), 0.0, 0.5);
    EXPECT_NEAR(degFromRad(filter_.gyro_bias_rad_s()), 0.05, 0.01);
}

TEST_F(HedrBayesDriving, FollowsAWayOffTheCorridorsAndComesBack) {
    drive(60.0, 0.0);
    drive(1.0, 0.0, 20.0);
    drive(40.0, 0.0);
    EXPECT_NEAR(errorDeg(), 0.0, 3.0);
    drive(1.0, 0.0, -20.0);
    drive(40.0, 0.0);
    EXPECT_NEAR(errorDeg(), 0.0, 1.0);
}

TEST_F(HedrBayesDriving, SaysThatItIsLostWhereNothingIsStraight) {
    drive(600.0, 0.0, 5.0);
    EXPECT_TRUE(filter_.status().lost);
}

TEST_F(HedrBayesDriving, KeepsItsCovarianceSymmetricAndPositive) {
    for (int leg = 0; leg < 20; ++leg) {
        drive(20.0, 0.02);
        drive(3.0, 0.02, leg % 3 == 0 ? -30.0 : 30.0);
        const Eigen::Matrix3d covariance = filter_.covariance();
        EXPECT_TRUE(covariance.isApprox(covariance.transpose(), 1e-9));
        EXPECT_GT(covariance.determinant(), 0.0);
        EXPECT_GT(covariance(0, 0), 0.0);
        EXPECT_GT(covariance(2, 2), 0.0);
    }
}

// The error of a turn is in the heading, in the leg and in what the encoders say of it.
TEST(HedrBayes, KeepsItsVariancesPositiveWithAWildGyro) {
    for (const double noise : {0.15, 1.0, 1e5}) {
        Vehicle vehicle;
        vehicle.gyro_noise_rad_s_sqrthz = noise;
        HedrBayes filter({}, hedrBayesPreset(vehicle));
        for (int i = 1; i <= 20000; ++i) {
            const double turn = i % 1500 < 100 ? 0.016 : 0.001 * std::sin(0.1 * i);
            filter.update({.t_s = 0.02 * i,
                           .dt_s = 0.02,
                           .distance_m = 0.01,
                           .odometry_turn_rad = turn,
                           .gyro_turn_rad = turn + 0.002 * std::cos(1.7 * i)});
            ASSERT_GE(filter.covariance().diagonal().minCoeff(), 0.0) << noise << ' ' << i;
            ASSERT_TRUE(std::isfinite(filter.pose().heading_rad)) << noise;
        }
    }
}

// A robot that stands for ten seconds and then drives, with a gyro whose vehicle file says nothing.
double headingSigmaAfterDriving_deg(double gyro_noise_deg_sqrts) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    std::mt19937 random(1);
    for (int i = 1; i <= 1500; ++i) {
        const bool standing = i <= 500;
        const double swerve = radFromDeg(i % 200 < 100 ? 5.0 : -5.0);  // along no corridor
        const double noise = (static_cast<double>(random() % 2001) / 1000.0 - 1.0) * std::sqrt(3.0);
        filter.update({.t_s = 0.02 * i,
                       .dt_s = 0.02,
                       .distance_m = standing ? 0.0 : 0.01,
                       .gyro_turn_rad = radFromDeg(gyro_noise_deg_sqrts) * std::sqrt(0.02) * noise +
                                        (standing ? 0.0 : swerve * 0.02),
                       .standing = standing});
    }
    return degFromRad(std::sqrt(filter.covariance()(2, 2)));
}

TEST(HedrBayes, LearnsHowNoisyTheGyroIsWhileItStands) {
    const double usual = headingSigmaAfterDriving_deg(0.03);
    const double noisy = headingSigmaAfterDriving_deg(0.2);
    EXPECT_GT(noisy, 2.0 * usual);
    EXPECT_LT(noisy, 4.0 * usual);
}

// Nobody keeps straight where no wall guides him: a long slow bend is not taken for a drift of the
// gyro, of which a standing start told that it has none.
TEST(HedrBayes, LetsAWayOffTheCorridorsBend) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    double t_s = 0.0;
    double heading_rad = 0.0;
    const auto drive = [&](double seconds, double turn_deg_s, bool standing = false) {
        for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i) {
            const double turn_rad = radFromDeg(turn_deg_s) * 0.02;
            t_s += 0.02;
            heading_rad += turn_rad;
            filter.update({.t_s = t_s,
                           .dt_s = 0.02,
                           .distance_m = standing ? 0.0 : 0.01,
                           .odometry_turn_rad = turn_rad,
                           .gyro_turn_rad = turn_rad,
                           .standing = standing});
        }
    };
    drive(10.0, 0.0, true);
    drive(60.0, 0.0);
    drive(1.0, 30.0);
    drive(40.0, 1.0);
    EXPECT_NEAR(degFromRad(filter.pose().heading_rad - heading_rad), 0.0, 5.0);
}

// Without a standing start nothing tells the bias but the wheels, here off by 0.1 °/s. That a gyro
// with next to no bias has been calibrated is likelier than that both are off by the same.
TEST(HedrBayes, BelievesThatAGyroWithHardlyABiasIsCalibrated) {
    HedrBayes filter({}, hedrBayesPreset(Vehicle{}));
    for (int i = 1; i <= 3000; ++i) {
        const double turn = radFromDeg(8.0) * std::sin(0.01 * i) * 0.02;
        filter.update({.t_s = 0.02 * i,
                       .dt_s = 0.02,
                       .distance_m = 0.01,
                       .odometry_turn_rad = turn - radFromDeg(0.1) * 0.02,
                       .gyro_turn_rad = turn});
    }
    EXPECT_LT(std::abs(degFromRad(filter.gyro_bias_rad_s())), 0.05);
}

}  // namespace
}  // namespace hedr
