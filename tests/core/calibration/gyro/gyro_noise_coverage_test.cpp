#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "core/calibration/gyro/gyro_noise.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/gyro/warmup_blocks.h"

namespace hedr {
namespace {

// A standing gyro, and what makes its noise harder to tell.
struct NoiseCase {
    const char* name;
    std::size_t readings = 3000;
    double walk_deg_s_sqrts = 0.0;
    double ramp_deg_s = 0.0;  // over the record
    std::size_t outliers = 0;
    double flicker_deg_s = 0.0;
};

constexpr double kPeriod_s = 0.1;
constexpr double kNoise_deg_s_sqrthz = 0.02;

std::vector<SensorReport> recordOf(const NoiseCase& each, Random& random) {
    std::vector<SensorReport> reports;
    double walked_deg_s = 0.0;
    Flicker flicker(each.flicker_deg_s, kPeriod_s, random);
    for (std::size_t i = 0; i < each.readings; ++i) {
        const double t_s = kPeriod_s * static_cast<double>(i);
        const double share = static_cast<double>(i) / static_cast<double>(each.readings);
        walked_deg_s += each.walk_deg_s_sqrts * std::sqrt(kPeriod_s) * random.normal();
        const double wandered_deg_s =
            walked_deg_s + (each.flicker_deg_s > 0.0 ? flicker.next() : 0.0);
        const double rate_deg_s = 0.5 + wandered_deg_s + each.ramp_deg_s * share +
                                  kNoise_deg_s_sqrthz / std::sqrt(kPeriod_s) * random.normal();
        reports.push_back({.robot_time_s = t_s, .gyro = GyroRate{radFromDeg(rate_deg_s)}});
    }
    for (std::size_t i = 0; i < each.outliers; ++i) {
        const auto place =
            static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(each.readings) - 1.0));
        reports[place].gyro = GyroRate{radFromDeg(random.uniform(-100.0, 100.0))};
    }
    return reports;
}

// Of many records with one truth.
struct Held {
    double truth = 0.0;
    int found = 0;
    int held = 0;
    double error = 0.0;   // sum
    double stated = 0.0;  // sum of the standard errors

    void add(const NoiseCoefficient& coefficient) {
        held += coefficient.interval.contains(truth) ? 1 : 0;
        if (!coefficient.found) return;
        ++found;
        error += coefficient.found->value - truth;
        stated += coefficient.found->standard_error;
    }
};

void print(const char* name, const Held& held, int runs) {
    std::cout << ' ' << name << " held in " << 100.0 * held.held / runs << " %, found in "
              << 100.0 * held.found / runs << " %";
    if (held.found > 0) std::cout << ", mean error " << held.error / held.stated << " sigma";
    std::cout << ';';
}

void expectHonest(const Held& held, int runs) {
    EXPECT_LT(std::abs(held.error), 0.2 * held.stated);
    EXPECT_GE(held.held, 0.93 * runs);
    EXPECT_LE(held.held, 0.97 * runs);
}

class GyroNoiseCoverage : public testing::TestWithParam<NoiseCase> {};

// What is found in each record: N, and a walk that stands out. Of the others there is a bound. The
// fit's constants were chosen with seeds 5, 6, 21 and 22, so the figures are of another one.
TEST_P(GyroNoiseCoverage, DISABLED_IsAsStated) {
    constexpr int kRuns = 2000;
    Random random(32);
    Held noise{radFromDeg(kNoise_deg_s_sqrthz)};
    Held instability{radFromDeg(GetParam().flicker_deg_s)};
    Held walk{radFromDeg(GetParam().walk_deg_s_sqrts)};
    for (int run = 0; run < kRuns; ++run) {
        const auto result = calibrateGyroNoise(recordOf(GetParam(), random), {});
        ASSERT_TRUE(result.fit) << result.calibration.reason;
        noise.add(result.fit->angle_walk_rad_s_sqrthz);
        instability.add(result.fit->instability_rad_s);
        walk.add(result.fit->rate_walk_rad_s_sqrts);
    }
    std::cout << GetParam().name << ':';
    print("N", noise, kRuns);
    print("B", instability, kRuns);
    print("K", walk, kRuns);
    std::cout << '\n';
    EXPECT_EQ(noise.found, kRuns);
    expectHonest(noise, kRuns);
    if (walk.found == kRuns) expectHonest(walk, kRuns);
    EXPECT_GE(walk.held, 0.93 * kRuns);
    EXPECT_GE(instability.held, 0.93 * kRuns);
}

INSTANTIATE_TEST_SUITE_P(
    All, GyroNoiseCoverage,
    testing::Values(NoiseCase{.name = "few", .readings = 320},
                    NoiseCase{.name = "few_outlier", .readings = 320, .outliers = 1},
                    NoiseCase{.name = "few_flicker", .readings = 320, .flicker_deg_s = 0.02},
                    NoiseCase{.name = "minute", .readings = 600}, NoiseCase{.name = "plain"},
                    NoiseCase{.name = "outlier", .outliers = 1},
                    NoiseCase{.name = "outliers", .outliers = 10},
                    NoiseCase{.name = "ramp", .ramp_deg_s = 0.01},
                    NoiseCase{.name = "steep_ramp", .ramp_deg_s = 0.1},
                    NoiseCase{.name = "flicker", .flicker_deg_s = 0.003},
                    NoiseCase{.name = "long", .readings = 20000},
                    NoiseCase{.name = "long_ramp", .readings = 20000, .ramp_deg_s = 0.05},
                    NoiseCase{.name = "long_flicker", .readings = 20000, .flicker_deg_s = 0.003},
                    NoiseCase{.name = "walk", .readings = 20000, .walk_deg_s_sqrts = 0.001},
                    NoiseCase{.name = "long_walk", .readings = 20000, .walk_deg_s_sqrts = 0.005}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace hedr
