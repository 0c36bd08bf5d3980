#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <vector>

#include "core/calibration/gyro/warmup.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"
#include "tests/core/calibration/gyro/warmup_blocks.h"
#include "tests/core/calibration/gyro/warmup_stand.h"

namespace hedr {
namespace {

// A calibration with random trouble, and what the gyro really did.
struct Chance {
    Stand stand{};
    Vehicle believed{};
    std::vector<SensorReport> reports{};

    double truth(double t_s) const {
        return biasAt(stand.curve, t_s) + (stand.besides ? stand.besides(t_s) : 0.0);
    }
};

double logUniform(Random& random, double low, double high) {
    return low * std::exp(random.uniform() * std::log(high / low));
}

std::function<double(double)> randomTrouble(RoomTemperature room, Random& random,
                                            double duration_s) {
    const double size = radFromDeg(logUniform(random, 0.003, 0.3));
    const double at_s = random.uniform(0.0, duration_s);
    const double period_s = logUniform(random, 10.0, duration_s);
    switch (static_cast<int>(random.uniform(0.0, 9.0))) {
        case 0:
            if (room == RoomTemperature::kMayChange) return {};  // it is told, and no trouble
            return [=](double t_s) { return size * t_s / duration_s; };
        case 1:
            return [=](double t_s) { return t_s > at_s ? size : 0.0; };
        case 2:
            return [=](double t_s) { return size * std::sin(6.28 * t_s / period_s); };
        case 3:
            return [=](double t_s) { return -size * std::expm1(-t_s / period_s); };
        case 4:
            return [=](double t_s) { return std::abs(t_s - at_s) < 0.15 ? 10.0 * size : 0.0; };
        case 5:
            return [=](double t_s) { return std::abs(t_s - at_s) < 0.1 * duration_s ? size : 0.0; };
        case 6: {
            auto flicker = std::make_shared<Flicker>(0.2 * size, 0.1, random);
            auto values = std::make_shared<std::vector<double>>();
            for (double t_s = 0.0; t_s <= duration_s + 1.0; t_s += 0.1)
                values->push_back(flicker->next());
            return [=](double t_s) {
                return (*values)[std::min(values->size() - 1, static_cast<std::size_t>(t_s * 10))];
            };
        }
        default:
            return {};
    }
}

void believeSomething(Chance& chance, Random& random) {
    const GyroDrift& curve = chance.stand.curve;
    const double off = random.uniform() < 0.5 ? 0.02 : 0.3;
    const auto nearly = [&](double value) { return value * (1.0 + off * random.normal() / 2.0); };
    switch (static_cast<int>(random.uniform(0.0, 4.0))) {
        case 0:
            chance.believed.gyro_bias_rad_s = curve.c1_rad_s + curve.c2_rad_s;
            break;
        case 1:
            chance.believed.gyro_drift = curve;
            break;
        case 2:
            chance.believed.gyro_drift = GyroDrift{nearly(curve.c1_rad_s), nearly(curve.c2_rad_s),
                                                   std::abs(nearly(curve.time_s)) + 1.0};
            break;
        default:
            break;
    }
}

// What the robot says in a room that changes; its drift is no part of the truth.
std::vector<SensorReport> reportsInAChangingRoom(const Stand& stand, Random& random) {
    Stand in_room = stand;
    const double drift_rad_s2 = radFromDeg(0.05 * random.normal()) / (60.0 * stand.minutes);
    in_room.besides = [drift_rad_s2, besides = stand.besides](double t_s) {
        return drift_rad_s2 * t_s + (besides ? besides(t_s) : 0.0);
    };
    return reportsOf(in_room, random);
}

Chance randomChance(RoomTemperature room, Random& random) {
    Chance chance;
    Stand& stand = chance.stand;
    const bool steady = room == RoomTemperature::kSteady;
    stand.minutes = logUniform(random, 2.0, steady ? 45.0 : 90.0);
    stand.rate_hz = 10.0;
    const double c1 = random.uniform() < 0.2 ? 0.0 : logUniform(random, 0.005, 0.5);
    stand.curve = {radFromDeg(random.uniform() < 0.5 ? c1 : -c1),
                   radFromDeg(random.uniform(-1.0, 1.0)), logUniform(random, 60.0, 1200.0)};
    stand.noise_rad_s_sqrthz = radFromDeg(logUniform(random, 0.005, 0.05));
    stand.besides = randomTrouble(room, random, 60.0 * stand.minutes);
    believeSomething(chance, random);
    chance.reports = steady ? reportsOf(stand, random) : reportsInAChangingRoom(stand, random);
    return chance;
}

// Root mean square error of a bias over the record.
double errorOf(const Chance& chance, const std::function<double(double)>& bias) {
    double squares = 0.0;
    constexpr int kPlaces = 300;
    for (int i = 0; i < kPlaces; ++i) {
        const double t_s = 60.0 * chance.stand.minutes * (i + 0.5) / kPlaces;
        squares += std::pow(bias(t_s) - chance.truth(t_s), 2) / kPlaces;
    }
    return std::sqrt(squares);
}

double oldErrorOf(const Chance& chance) {
    const Vehicle& believed = chance.believed;
    const double start_rad_s = chance.truth(30.0);
    return errorOf(chance, [&](double t_s) {
        return believed.gyro_drift ? biasAt(*believed.gyro_drift, t_s)
                                   : believed.gyro_bias_rad_s.value_or(start_rad_s);
    });
}

struct Tally {
    int accepted = 0;
    int worse = 0;
};

Tally calibrateAtRandom(RoomTemperature room, int runs, std::uint64_t seed) {
    Random random(seed);
    Tally tally;
    for (int run = 0; run < runs; ++run) {
        const Chance chance = randomChance(room, random);
        const Warmup warmup = calibrateWarmup(chance.reports, chance.believed, {.room = room});
        if (warmup.calibration.verdict != Verdict::kAccepted) continue;
        ++tally.accepted;
        const GyroDrift curve = *calibrated(chance.believed, warmup.calibration)->gyro_drift;
        const double after = errorOf(chance, [&](double t_s) { return biasAt(curve, t_s); });
        if (after <= oldErrorOf(chance)) continue;
        ++tally.worse;
        std::cout << "run " << run << ": " << degFromRad(oldErrorOf(chance)) << " before, "
                  << degFromRad(after) << " deg/s after, " << chance.stand.minutes << " min\n";
    }
    return tally;
}

TEST(TroubledWarmups, AcceptsNothingWorseInOneHundredWithTrouble) {
    EXPECT_EQ(calibrateAtRandom(RoomTemperature::kSteady, 100, 10).worse, 0);
    EXPECT_EQ(calibrateAtRandom(RoomTemperature::kMayChange, 50, 13).worse, 0);
}

TEST(TroubledWarmups, DISABLED_AcceptsNothingWorseInAThousandWithTrouble) {
    for (const RoomTemperature room : {RoomTemperature::kSteady, RoomTemperature::kMayChange}) {
        const Tally tally = calibrateAtRandom(room, 1000, 11);
        std::cout << (room == RoomTemperature::kSteady ? "steady room: " : "changing room: ")
                  << tally.accepted << " of 1000 accepted, " << tally.worse << " worse\n";
        EXPECT_EQ(tally.worse, 0);
    }
}

// Whether it is known is told by the samples themselves, which might choose lucky ones.
TEST(WarmupsThatAreAccepted, DISABLED_StateIntervalsThatHold) {
    struct Way {
        double minutes;
        RoomTemperature room;
    };
    for (const auto& [minutes, room] : {Way{15.0, RoomTemperature::kSteady},
                                        {20.0, RoomTemperature::kSteady},
                                        {30.0, RoomTemperature::kMayChange},
                                        {35.0, RoomTemperature::kMayChange},
                                        {40.0, RoomTemperature::kMayChange}}) {
        Random random(12);
        const GyroDrift& truth = kGyrostar;
        int accepted = 0;
        std::array<int, 3> held{};
        for (int run = 0; run < 1000; ++run) {
            const Stand stand{.minutes = minutes, .rate_hz = 10.0};
            const auto reports = room == RoomTemperature::kSteady
                                     ? reportsOf(stand, random)
                                     : reportsInAChangingRoom(stand, random);
            const Calibration calibration =
                calibrateWarmup(reports, {}, {.room = room}).calibration;
            if (calibration.verdict != Verdict::kAccepted) continue;
            ++accepted;
            const std::array truths{truth.c1_rad_s, truth.c2_rad_s, truth.time_s};
            for (std::size_t i = 0; i < held.size(); ++i)
                held[i] += calibration.found[i].now.interval().contains(truths[i]) ? 1 : 0;
        }
        std::cout << minutes << " min: " << accepted << " of 1000 accepted; C1, C2, T held in "
                  << held[0] << ", " << held[1] << ", " << held[2] << '\n';
        for (const int each : held) {
            EXPECT_GE(each, 0.93 * accepted);
            EXPECT_LE(each, 0.97 * accepted);
        }
    }
}

// Of records that end when only some of them are known: those whose T looks short. No rule that
// goes by T can be better than the table's last column: the interval misses half of its five per
// cent where T looks short, and all of those are accepted.
TEST(WarmupsThatAreAccepted, DISABLED_AreChosenByLuckWhereTheyEndEarly) {
    constexpr int kRuns = 6000;
    for (const double minutes : {12.0, 13.0, 14.0, 28.0, 30.0, 32.0}) {
        const auto room = minutes < 20.0 ? RoomTemperature::kSteady : RoomTemperature::kMayChange;
        Random random(77);
        int known = 0;
        int held = 0;
        int held_in_all = 0;
        for (int run = 0; run < kRuns; ++run) {
            const WarmupFit fit = fitWarmup(blocksOf({.minutes = minutes}, random), room);
            const bool holds = fit.time_s().interval().contains(kGyrostar.time_s);
            held_in_all += holds ? 1 : 0;
            if (fit.relativeErrorOfTime() > kKnownTimeError) continue;
            ++known;
            held += holds ? 1 : 0;
        }
        const double share = static_cast<double>(known) / kRuns;
        std::cout << (room == RoomTemperature::kSteady ? "steady" : "changing") << " room, "
                  << minutes << " min: T holds in " << 100.0 * held_in_all / kRuns
                  << " %; known in " << 100.0 * share << " %, holds in " << 100.0 * held / known
                  << " % of those, could in " << 100.0 - 2.5 / share << " %\n";
        EXPECT_GE(held_in_all, 0.93 * kRuns);
        EXPECT_LE(held_in_all, 0.97 * kRuns);
    }
}

// The fit of a growing record at the first moment when T is known.
WarmupFit fitWhenFirstKnown(RoomTemperature room, Random& random) {
    constexpr double kBlock_s = 10.0;
    constexpr std::size_t kLooksEach = 3;
    std::vector<WarmupBlock> blocks;
    for (;;) {
        WarmupBlock next{kBlock_s * static_cast<double>(blocks.size()), 0.0, 0.0, kBlock_s};
        next.end_s = next.begin_s + kBlock_s;
        next.mean_rad_s = meanBias(next, kGyrostar) +
                          kGyrostarNoise_rad_s_sqrthz / std::sqrt(kBlock_s) * random.normal();
        blocks.push_back(next);
        if (blocks.size() < 2 * kFewestWarmupBlocks || blocks.size() % kLooksEach > 0) continue;
        const WarmupFit fit = fitWarmup(blocks, room);
        if (fit.converged && fit.relativeErrorOfTime() <= kKnownTimeError) return fit;
    }
}

// As operators do it: they stop as soon as they may.
TEST(WarmupsThatAreAccepted, DISABLED_StateIntervalsThatHoldAtTheFirstMoment) {
    constexpr int kRuns = 3000;
    const std::array truths{kGyrostar.c1_rad_s, kGyrostar.c2_rad_s, kGyrostar.time_s};
    for (const RoomTemperature room : {RoomTemperature::kSteady, RoomTemperature::kMayChange}) {
        Random random(14);
        std::array<int, 3> held{};
        std::array<double, 3> errors{};  // in standard errors
        for (int run = 0; run < kRuns; ++run) {
            const WarmupFit fit = fitWhenFirstKnown(room, random);
            const std::array found{fit.c1_rad_s(), fit.c2_rad_s(), fit.time_s()};
            for (std::size_t i = 0; i < held.size(); ++i) {
                held[i] += found[i].interval().contains(truths[i]) ? 1 : 0;
                errors[i] += (found[i].value - truths[i]) / found[i].standard_error / kRuns;
            }
        }
        std::cout << (room == RoomTemperature::kSteady ? "steady" : "changing")
                  << " room: C1, C2, T held in " << held[0] << ", " << held[1] << ", " << held[2]
                  << " of " << kRuns << ", mean errors " << errors[0] << ", " << errors[1] << ", "
                  << errors[2] << " standard errors\n";
        for (std::size_t i = 0; i < held.size(); ++i) {
            EXPECT_GE(held[i], 0.93 * kRuns);
            EXPECT_LE(held[i], 0.97 * kRuns);
            EXPECT_LT(std::abs(errors[i]), 0.2);
        }
    }
}

}  // namespace
}  // namespace hedr
