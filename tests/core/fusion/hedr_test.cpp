#include "core/fusion/hedr.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <vector>

#include "core/fusion/tracker.h"
#include "core/robot/sensor_csv.h"
#include "core/simulation/scenario.h"
#include "core/track/evaluation.h"
#include "core/track/track_file.h"

namespace hedr {
namespace {

constexpr double kRate_hz = 50.0;
constexpr double kSpeed_m_s = 0.6;

Motion driving(double dt_s, double turn_rad) {
    return {.t_s = 0.0,
            .dt_s = dt_s,
            .distance_m = kSpeed_m_s * dt_s,
            .odometry_turn_rad = turn_rad,
            .gyro_turn_rad = turn_rad};
}

// RMS of the heading, in degrees, of a straight drive with a constant drift, after a minute.
double headingRms(const HedrConfig& config, double drift_deg_s, double seconds,
                  double rate_hz = kRate_hz) {
    Hedr hedr({}, config);
    const double dt_s = 1.0 / rate_hz;
    double sum = 0.0;
    int count = 0;
    for (double t_s = 0.0; t_s < seconds; t_s += dt_s) {
        hedr.update(driving(dt_s, radFromDeg(drift_deg_s) * dt_s));
        if (t_s < 60.0) continue;
        sum += std::pow(degFromRad(hedr.pose().heading_rad), 2);
        ++count;
    }
    return std::sqrt(sum / count);
}

HedrConfig printedSign() {
    HedrConfig config;
    config.gain_rad_s2 = -config.gain_rad_s2;  // Eqs. (7) and (10) as printed
    config.damping_rad_s = 0.0;
    return config;
}

TEST(Hedr, RemovesTheDriftOfAStraightDrive) {
    EXPECT_LT(headingRms({}, 0.05, 600.0), 0.15);
    EXPECT_LT(headingRms({}, -0.05, 600.0), 0.15);
}

TEST(Hedr, ThePrintedSignSettlesBetweenTwoDirections) {
    EXPECT_GT(headingRms(printedSign(), 0.05, 600.0), 17.0);
}

TEST(Hedr, SaysThatItIsLostWhereTheDriftIsFasterThanItCanFollow) {
    Hedr hedr({}, {});
    for (int i = 0; i < 300 * 50; ++i) hedr.update(driving(0.02, radFromDeg(0.05) * 0.02));
    EXPECT_FALSE(hedr.status().lost);
    bool lost = false;
    for (int i = 0; i < 120 * 50; ++i) {
        hedr.update(driving(0.02, radFromDeg(3.0) * 0.02));
        lost = lost || hedr.status().lost;
    }
    EXPECT_TRUE(lost);
}

TEST(Hedr, LeavesAWayOffEveryDirectionAlone) {
    Hedr hedr({}, {});
    for (int i = 0; i < 60 * 50; ++i) hedr.update(driving(0.02, 0.0));
    for (int i = 0; i < 25; ++i) hedr.update(driving(0.02, radFromDeg(40.0) * 0.02));
    for (int i = 0; i < 60 * 50; ++i) hedr.update(driving(0.02, 0.0));
    EXPECT_EQ(hedr.status().reason, SuspendReason::kOffCorridors);
    EXPECT_NEAR(degFromRad(hedr.pose().heading_rad), 20.0, 1.5);
}

TEST(Hedr, ItsGainMeansTheSameAtEverySamplingRate) {
    Hedr slow({}, {});
    Hedr fast({}, {});
    for (int i = 0; i < 100; ++i) slow.update(driving(0.1, radFromDeg(0.5) * 0.1));
    for (int i = 0; i < 2000; ++i) fast.update(driving(0.005, radFromDeg(0.5) * 0.005));
    EXPECT_NEAR(degFromRad(slow.pose().heading_rad), degFromRad(fast.pose().heading_rad), 0.1);
    EXPECT_LT(headingRms({}, 0.05, 600.0, 10.0), 0.15);
    EXPECT_LT(headingRms({}, 0.05, 600.0, 200.0), 0.15);
}

TEST(Hedr, ShowsTheDriftAsARunningMeanNotAsTheChatteringIntegrator) {
    Hedr hedr({}, {});
    for (int i = 0; i < 300 * 50; ++i) hedr.update(driving(0.02, radFromDeg(0.05) * 0.02));
    EXPECT_NEAR(degFromRad(hedr.status().drift_rad_s), 0.05, 0.015);
}

TEST(Hedr, IsSuspendedWhileItTurnsAndWhileItStands) {
    Hedr hedr({}, {});
    for (int i = 0; i < 500; ++i) hedr.update(driving(0.02, 0.0));
    EXPECT_EQ(hedr.status().state, HedrState::kActive);
    for (int i = 0; i < 100; ++i) hedr.update(driving(0.02, radFromDeg(45.0) * 0.02));
    EXPECT_EQ(hedr.status().reason, SuspendReason::kTurning);
    EXPECT_NEAR(hedr.status().seconds_since_active, 2.0, 0.3);
    Motion standing{.dt_s = 0.02, .gyro_turn_rad = radFromDeg(0.1) * 0.02, .standing = true};
    for (int i = 0; i < 100; ++i) hedr.update(standing);
    EXPECT_EQ(hedr.status().reason, SuspendReason::kStanding);
}

TEST(Hedr, LearnsNothingOverAGapOfAnHour) {
    Hedr method({}, {.direction_rad = 0.0});
    for (int i = 0; i < 5000; ++i) {
        method.update({.dt_s = 0.02, .distance_m = 0.01, .gyro_turn_rad = radFromDeg(1e-4)});
    }
    const Pose<World> before = method.pose();
    const double drift_rad_s = method.status().drift_rad_s;
    method.update({.dt_s = 3600.0, .distance_m = 1.0, .gyro_turn_rad = 0.0});
    EXPECT_NEAR(method.pose().heading_rad, before.heading_rad, radFromDeg(2.0));
    method.update({.dt_s = 0.02, .distance_m = 0.01, .gyro_turn_rad = 0.0});
    EXPECT_LE(std::abs(method.status().drift_rad_s), std::abs(drift_rad_s));
}

TEST(Hedr, DropsWhatNothingHasConfirmedForLong) {
    Hedr hedr({}, {.hold_s = 30.0});
    for (int i = 0; i < 200 * 50; ++i) hedr.update(driving(0.02, radFromDeg(0.05) * 0.02));
    ASSERT_GT(degFromRad(hedr.status().drift_rad_s), 0.03);
    for (int i = 0; i < 31 * 50; ++i) hedr.update(driving(0.02, radFromDeg(30.0) * 0.02));
    EXPECT_TRUE(hedr.status().held_expired);
    EXPECT_EQ(hedr.status().drift_rad_s, 0.0);
}

TEST(Hedr, FindsCorridorsThatAreNotParallelToTheStart) {
    Hedr hedr({}, {});
    const auto turn = [&](double deg) {
        for (int i = 0; i < 50; ++i) hedr.update(driving(0.02, radFromDeg(deg) / 50.0));
    };
    const auto straight = [&](double metres) {
        const int steps = static_cast<int>(metres / kSpeed_m_s * kRate_hz);
        for (int i = 0; i < steps; ++i) hedr.update(driving(0.02, radFromDeg(0.02) * 0.02));
    };
    turn(30.0);
    straight(60.0);
    turn(90.0);
    straight(60.0);
    EXPECT_NEAR(degFromRad(hedr.pose().heading_rad), 120.0, 1.5);
}

TEST(Hedr, ABuildingWithEightDirectionsKeepsADiagonalCorridor) {
    HedrConfig config;
    config.interval_rad = radFromDeg(45.0);
    Hedr hedr({}, config);
    for (int i = 0; i < 50; ++i) hedr.update(driving(0.02, radFromDeg(45.0) / 50.0));
    for (int i = 0; i < 300 * 50; ++i) hedr.update(driving(0.02, radFromDeg(0.03) * 0.02));
    EXPECT_NEAR(degFromRad(hedr.pose().heading_rad), 45.0, 1.0);
}

struct Spread {
    double median = 0.0;
    double worst = 0.0;
};

Spread spreadOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return {0.5 * (values[half - 1] + values[half]), values.back()};
}

// Heading error, degrees rms, over 20 simulated PackBot missions of 20 minutes.
Spread headingErrorOverSeeds(const char* estimator, const FusionConfig* changed = nullptr,
                             const char* scenario = "packbot-corridors") {
    std::vector<double> errors;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const SimulatedMission mission = simulate(scenarioByName(scenario).value(), seed);
        const FusionConfig config = changed ? *changed : fusionPreset(mission.vehicle);
        Tracker tracker({.vehicle = mission.vehicle,
                         .config = config,
                         .start = mission.start,
                         .clock_period_s = MotionBuilder::kNoWrap,
                         .estimators = {findEstimator(estimator)}});
        std::vector<TrackPoint> track;
        for (const SensorReport& report : mission.sensors) {
            if (tracker.add(report)) track.push_back(tracker.point(0));
        }
        errors.push_back(
            evaluate(track, mission.truth, Alignment::kStart).value().heading_rmse_deg);
    }
    return spreadOf(errors);
}

TEST(HedrOnSimulatedPackbots, KeepsTheHeadingWhereTheGyroDriftsTensOfDegrees) {
    const Spread gyro = headingErrorOverSeeds("gyro");
    const Spread hedr = headingErrorOverSeeds("hedr");
    std::cout << "heading error, degrees rms over 20 seeds: gyro median " << gyro.median
              << ", hedr median " << hedr.median << ", worst " << hedr.worst << '\n';
    EXPECT_GT(gyro.median, 10.0);
    EXPECT_LE(hedr.median, 1.1);
    EXPECT_LE(hedr.worst, 2.0);
}

TEST(HedrOnSimulatedPackbots, CrossesHallsAndKnowsEightDirections) {
    EXPECT_LE(headingErrorOverSeeds("hedr", nullptr, "packbot-hall").median, 2.5);
    EXPECT_LE(headingErrorOverSeeds("hedr", nullptr, "packbot-45").worst, 2.0);
    EXPECT_LE(headingErrorOverSeeds("hedr", nullptr, "packbot-offset").median, 2.0);
}

// Without a plan one seed in four ends 8 to 9 degrees off.
TEST(HedrOnSimulatedPackbots, IsToldTheDirectionThatAStartAslantHides) {
    FusionConfig told;
    ASSERT_TRUE(setFusionValue(told, "direction_deg", "0"));
    const Spread hedr = headingErrorOverSeeds("hedr", &told, "packbot-offset");
    const Spread bayes = headingErrorOverSeeds("hedr_bayes", &told, "packbot-offset");
    std::cout << "heading error, degrees rms over 20 seeds: hedr median " << hedr.median
              << ", worst " << hedr.worst << ", hedr_bayes median " << bayes.median << ", worst "
              << bayes.worst << '\n';
    EXPECT_LE(hedr.median, 1.0);
    EXPECT_LE(hedr.worst, 2.0);
    EXPECT_LE(bayes.worst, 1.0);
}

TEST(HedrOnSimulatedPackbots, ThePrintedSignFails) {
    FusionConfig config;
    config.hedr = printedSign();
    EXPECT_GT(headingErrorOverSeeds("hedr", &config).median, 10.0);
}

struct Recording {
    const char* name;
    double hedr_limit_m;
    double odometry_m;
};

void PrintTo(const Recording& recording, std::ostream* out) { *out << recording.name; }

class HedrOnRecordings : public ::testing::TestWithParam<Recording> {
  protected:
    static Evaluation run(const std::filesystem::path& folder, const char* estimator) {
        const Vehicle vehicle = loadVehicle(folder / "vehicle.toml").value();
        Tracker tracker({.vehicle = vehicle,
                         .config = fusionPreset(vehicle),
                         .start = {},
                         .clock_period_s = MotionBuilder::kNoWrap,
                         .estimators = {findEstimator(estimator)}});
        std::vector<TrackPoint> track;
        const SensorLog log = loadSensorLog(folder / "sensors.csv").value();
        for (const SensorReport& report : log.reports) {
            if (tracker.add(report)) track.push_back(tracker.point(0));
        }
        const auto truth = loadTrack(folder / "truth.csv").value();
        return evaluate(track, truth, Alignment::kStart).value();
    }
};

// One preset for encoders as heading sensor serves them all.
TEST_P(HedrOnRecordings, StaysNearTheTruth) {
    const auto folder = std::filesystem::path(HEDR_SOURCE_DIR) / "../shared/data" / GetParam().name;
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "the recording " << GetParam().name << " is not on this machine";
    }
    EXPECT_NEAR(run(folder, "odometry").ape_rmse_m, GetParam().odometry_m,
                0.05 * GetParam().odometry_m);
    EXPECT_LE(run(folder, "hedr").ape_rmse_m, GetParam().hedr_limit_m);
}

INSTANTIATE_TEST_SUITE_P(Real, HedrOnRecordings,
                         ::testing::Values(Recording{"tuc_corridor", 4.0, 82.9},
                                           Recording{"wean_1", 0.7, 2.04}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace hedr
