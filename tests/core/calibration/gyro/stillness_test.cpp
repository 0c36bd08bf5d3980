#include "core/calibration/gyro/stillness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "core/geometry/angle.h"
#include "core/robot/vehicle.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

// A standing gyro, and what is done to it: a further rate, °/s, at a time.
struct Trial {
    double rate_hz = 50.0;
    double noise_deg_s_sqrthz = 0.02;
    double duration_s = 90.0;
    std::function<double(double t_s, Random& random)> disturbance = [](double, Random&) {
        return 0.0;
    };
};

std::vector<GyroSample> samplesOf(const Trial& trial, Random& random) {
    const double bias_deg_s = random.uniform(-2.0, 2.0);
    const double period_s = 1.0 / trial.rate_hz;
    const double deviation_deg_s = trial.noise_deg_s_sqrthz * std::sqrt(trial.rate_hz);
    std::vector<GyroSample> samples;
    for (double t_s = period_s; t_s <= trial.duration_s; t_s += period_s) {
        const double rate_deg_s =
            bias_deg_s + deviation_deg_s * random.normal() + trial.disturbance(t_s, random);
        samples.push_back({t_s, period_s, radFromDeg(rate_deg_s)});
    }
    return samples;
}

// Until the first motion.
Stillness watched(const std::vector<GyroSample>& samples) {
    Stillness stillness{Vehicle{}};
    for (const GyroSample& sample : samples) {
        stillness.add(sample);
        if (!stillness.disturbances().empty()) break;
    }
    return stillness;
}

Stillness watchedToTheEnd(const std::vector<GyroSample>& samples) {
    Stillness stillness{Vehicle{}};
    for (const GyroSample& sample : samples) stillness.add(sample);
    return stillness;
}

// The noise of the gyros that robots have: those recorded here have 0.01 to 0.04 °/s/sqrt(Hz).
Trial randomTrial(Random& random, double most_noise_deg_s_sqrthz) {
    Trial trial;
    trial.rate_hz = random.uniform() < 0.5 ? 50.0 : 100.0;
    trial.noise_deg_s_sqrthz = random.uniform(0.005, most_noise_deg_s_sqrthz);
    return trial;
}

// 0.2° in 0.3 s, as a rate of the mean over each sample.
Trial nudgeTrial(Random& random) {
    Trial trial = randomTrial(random, 0.04);
    const double begin_s = random.uniform(10.0, 60.0);
    const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
    const double period_s = 1.0 / trial.rate_hz;
    trial.duration_s = begin_s + 5.0;
    trial.disturbance = [=](double t_s, Random&) {
        const double overlap_s = std::min(t_s, begin_s + 0.3) - std::max(t_s - period_s, begin_s);
        return sign * std::max(0.0, overlap_s) / period_s * 0.2 / 0.3;
    };
    return trial;
}

// 0.05 °/s that begins half a minute or more after the measurement and lasts for a minute.
Trial slowTurnTrial(Random& random, double most_noise_deg_s_sqrthz = 0.02) {
    Trial trial = randomTrial(random, most_noise_deg_s_sqrthz);
    const double begin_s = random.uniform(30.0, 60.0);
    const double rate_deg_s = random.uniform() < 0.5 ? -0.05 : 0.05;
    trial.duration_s = begin_s + 60.0;
    trial.disturbance = [=](double t_s, Random&) { return t_s > begin_s ? rate_deg_s : 0.0; };
    return trial;
}

// Twice the noise of the gyro in all, broadband, or a tone of 5 to 30 Hz with twice its deviation.
Trial vibrationTrial(Random& random) {
    Trial trial = randomTrial(random, 0.04);
    const double begin_s = random.uniform(15.0, 60.0);
    const double deviation_deg_s = trial.noise_deg_s_sqrthz * std::sqrt(trial.rate_hz);
    const bool tone = random.uniform() < 0.5;
    const double angular_hz = 2.0 * kPi * random.uniform(5.0, std::min(30.0, 0.5 * trial.rate_hz));
    trial.duration_s = begin_s + 10.0;
    trial.disturbance = [=](double t_s, Random& now) {
        if (t_s < begin_s) return 0.0;
        return deviation_deg_s * (tone ? 2.0 * std::sqrt(2.0) * std::sin(angular_hz * t_s)
                                       : std::sqrt(3.0) * now.normal());
    };
    return trial;
}

Trial standingTrial(Random& random) {
    Trial trial = randomTrial(random, 0.05);
    trial.duration_s = random.uniform(60.0, 120.0);
    return trial;
}

// The share of trials in which a motion was seen.
template <class MakeTrial>
double shareSeen(int trials, MakeTrial makeTrial) {
    int seen = 0;
    for (int i = 0; i < trials; ++i) {
        Random random(static_cast<std::uint64_t>(i) + 1);
        const Trial trial = makeTrial(random);
        seen += watched(samplesOf(trial, random)).disturbances().empty() ? 0 : 1;
    }
    return static_cast<double>(seen) / trials;
}

constexpr int kTrials = 100;

TEST(Stillness, SeesANudge) { EXPECT_GE(shareSeen(kTrials, nudgeTrial), 0.99); }

TEST(Stillness, SeesASlowTurnThatBegins) {
    EXPECT_GE(shareSeen(kTrials, [](Random& random) { return slowTurnTrial(random); }), 0.99);
}

TEST(Stillness, SeesAVibration) { EXPECT_GE(shareSeen(kTrials, vibrationTrial), 0.99); }

TEST(Stillness, SeesNothingInStandingData) { EXPECT_LE(shareSeen(kTrials, standingTrial), 0.01); }

TEST(Stillness, DISABLED_SeesWhatItMustInAThousandTrials) {
    const auto slow = [](Random& random) { return slowTurnTrial(random); };
    const double nudges = shareSeen(1000, nudgeTrial);
    const double slow_turns = shareSeen(1000, slow);
    const double vibrations = shareSeen(1000, vibrationTrial);
    const double standing = shareSeen(1000, standingTrial);
    std::cout << "nudge " << nudges << ", slow turn " << slow_turns << ", vibration " << vibrations
              << ", standing " << standing << '\n';
    EXPECT_GE(nudges, 0.99);
    EXPECT_GE(slow_turns, 0.99);
    EXPECT_GE(vibrations, 0.99);
    EXPECT_LE(standing, 0.01);
}

// What noise leaves of it.
TEST(Stillness, DISABLED_SeesASlowTurnTheLessTheNoisierTheGyro) {
    for (const double noise : {0.01, 0.02, 0.025, 0.03, 0.04, 0.05}) {
        for (const double lasts_s : {30.0, 60.0, 120.0}) {
            const auto one = [=](Random& random) {
                Trial trial = slowTurnTrial(random);
                trial.noise_deg_s_sqrthz = noise;
                trial.duration_s += lasts_s - 60.0;
                return trial;
            };
            const double share = shareSeen(300, one);
            std::cout << "slow turn, noise " << noise << ", within " << lasts_s << " s: " << share
                      << '\n';
            if (noise <= 0.02 && lasts_s >= 60.0) {
                EXPECT_GE(share, 0.99);
            }
        }
    }
}

// What a gyro alone cannot tell: the same rate all the time is a bias.
TEST(Stillness, TakesASlowTurnFromTheBeginningForABiasWithoutEncoders) {
    Random random(3);
    const Trial trial{.disturbance = [](double, Random&) { return 0.05; }};
    const Stillness stillness = watched(samplesOf(trial, random));
    EXPECT_EQ(stillness.state(), Stillness::State::kStands);
    EXPECT_FALSE(stillness.hasWheels());
}

TEST(Stillness, SeesASlowTurnFromTheBeginningByTheEncoders) {
    Random random(4);
    const Trial trial{.noise_deg_s_sqrthz = 0.05, .duration_s = 20.0};
    const Vehicle vehicle;
    const double tick_m =
        kPi * vehicle.geometry.left_wheel_diameter_m / vehicle.geometry.ticks_per_revolution;
    Stillness stillness(vehicle);
    for (const GyroSample& sample : samplesOf(trial, random)) {
        const double rim_m = 0.5 * vehicle.geometry.wheelbase_m * radFromDeg(0.05) * sample.t_s;
        const auto ticks = static_cast<std::int64_t>(rim_m / tick_m);
        stillness.add(sample.t_s, WheelTicks{-ticks, ticks});
        stillness.add(sample);
    }
    ASSERT_FALSE(stillness.disturbances().empty());
    EXPECT_EQ(sentenceOf(stillness.disturbances().front().sign), "The encoders counted.");
    EXPECT_LT(stillness.disturbances().front().sign.since_s, 5.0);
}

TEST(Stillness, SaysHowFarItWasNudged) {
    Random random(5);
    Trial trial{.noise_deg_s_sqrthz = 0.01, .duration_s = 35.0};
    trial.disturbance = [](double t_s, Random&) {
        return t_s > 30.0 && t_s <= 30.3 ? 0.2 / 0.3 : 0.0;
    };
    const Stillness stillness = watched(samplesOf(trial, random));
    ASSERT_EQ(stillness.disturbances().size(), 1u);
    const MotionSign& sign = stillness.disturbances().front().sign;
    EXPECT_EQ(sentenceOf(sign), "The robot turned by about 0.2° within 0.3 s.");
    EXPECT_NEAR(sign.since_s, 30.0, 0.1);
}

TEST(Stillness, SaysThatItTurnsSlowly) {
    Random random(6);
    Trial trial{.duration_s = 120.0};
    trial.disturbance = [](double t_s, Random&) { return t_s > 50.0 ? 0.05 : 0.0; };
    const Stillness stillness = watched(samplesOf(trial, random));
    ASSERT_EQ(stillness.disturbances().size(), 1u);
    const MotionSign& sign = stillness.disturbances().front().sign;
    EXPECT_EQ(sign.kind, MotionSign::Kind::kTurnsSlowly);
    EXPECT_NEAR(degFromRad(sign.rate_rad_s), 0.05, 0.02);
    EXPECT_NEAR(sign.since_s, 50.0, 5.0);
}

TEST(Stillness, SaysThatItVibratesAndStandsAgainWhenThatIsOver) {
    Random random(7);
    Trial trial;
    trial.disturbance = [](double t_s, Random& now) {
        return t_s > 30.0 && t_s < 50.0 ? 0.4 * now.normal() : 0.0;
    };
    const Stillness stillness = watchedToTheEnd(samplesOf(trial, random));
    EXPECT_EQ(stillness.state(), Stillness::State::kStands);
    ASSERT_EQ(stillness.disturbances().size(), 1u);
    EXPECT_EQ(stillness.disturbances().front().sign.kind, MotionSign::Kind::kVibrates);
    EXPECT_NEAR(stillness.disturbances().front().until_s, 50.0, 2.0);
    ASSERT_EQ(stillness.standing().size(), 2u);
    EXPECT_NEAR(stillness.standing().front().end_s, 30.0, 2.0);
    EXPECT_NEAR(stillness.standing().back().begin_s, 50.0, 2.0);
}

TEST(Stillness, SaysThatItVibratedUntilNow) {
    Random random(8);
    Trial trial{.duration_s = 60.0};
    trial.disturbance = [](double t_s, Random& now) {
        return t_s < 40.0 ? 0.6 * now.normal() : 0.0;
    };
    const Stillness stillness = watched(samplesOf(trial, random));
    ASSERT_EQ(stillness.disturbances().size(), 1u);
    EXPECT_EQ(sentenceOf(stillness.disturbances().front().sign), "It vibrated until now.");
}

TEST(Stillness, IsTooEarlyToTellAtFirst) {
    Random random(9);
    EXPECT_EQ(Stillness{Vehicle{}}.state(), Stillness::State::kTooEarly);
    const Trial trial{.duration_s = 1.5};
    EXPECT_EQ(watched(samplesOf(trial, random)).state(), Stillness::State::kTooEarly);
}

TEST(Stillness, SaysThatARateWhichStaysChangedIsNoOldStanding) {
    Random random(10);
    Trial trial;
    trial.disturbance = [](double t_s, Random&) { return t_s > 30.0 ? 1.0 : 0.0; };
    const Stillness stillness = watchedToTheEnd(samplesOf(trial, random));
    ASSERT_EQ(stillness.disturbances().size(), 1u);
    EXPECT_TRUE(stillness.disturbances().front().rate_changed);
}

TEST(Stillness, PassesOverReadingsThatStandAlone) {
    Random random(11);
    std::vector<GyroSample> samples = samplesOf({.rate_hz = 10.0}, random);
    for (std::size_t i = 50; i < samples.size(); i += 150) samples[i].rate_rad_s += 0.03;
    EXPECT_TRUE(watched(samples).disturbances().empty());
}

TEST(Stillness, PassesOverTheStepsOfACoarseGyro) {
    Random random(12);
    std::vector<GyroSample> samples = samplesOf({.noise_deg_s_sqrthz = 0.002}, random);
    const double step_rad_s = radFromDeg(0.1);
    for (GyroSample& sample : samples) {
        sample.rate_rad_s = step_rad_s * std::round(sample.rate_rad_s / step_rad_s);
    }
    EXPECT_TRUE(watched(samples).disturbances().empty());
}

TEST(Stillness, EndsWhereNoReadingsCame) {
    Random random(13);
    std::vector<GyroSample> samples = samplesOf({.duration_s = 20.0}, random);
    for (std::size_t i = 500; i < samples.size(); ++i) samples[i].t_s += 3.0;
    samples[500].dt_s += 3.0;
    const Stillness stillness = watched(samples);
    ASSERT_EQ(stillness.disturbances().size(), 1u);
    EXPECT_EQ(sentenceOf(stillness.disturbances().front().sign), "No gyro readings came for 3 s.");
}

TEST(Stillness, TakesOneCountToAndFroOfFineEncodersForNone) {
    Vehicle vehicle;
    vehicle.geometry.ticks_per_revolution = 20000;
    Stillness stillness(vehicle);
    for (int i = 0; i < 100; ++i) stillness.add(0.1 * i, WheelTicks{i % 2, 0});
    EXPECT_TRUE(stillness.disturbances().empty());
}

TEST(Stillness, PassesOverBrokenOdometry) {
    Stillness stillness{Vehicle{}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    stillness.add(0.0, WheelTravel{nan, 0.0});
    stillness.add(1.0, WheelTravel{1.0, 1.0});
    stillness.add(2.0, WheelTravel{1.0, nan});
    stillness.add(3.0, std::monostate{});
    stillness.add(4.0, WheelTravel{1.0, 1.0});
    EXPECT_TRUE(stillness.disturbances().empty());
    stillness.add(5.0, WheelTravel{1.1, 1.1});
    EXPECT_EQ(stillness.disturbances().size(), 1u);
}

}  // namespace
}  // namespace hedr
