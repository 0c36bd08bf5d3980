// A magnetometer's calibration by somebody who does much wrong, in bad places.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/calibration/compass/compass_errors.h"
#include "tests/core/calibration/compass/simulated_magnetometer.h"

namespace hedr {
namespace {

using test::MagneticBench;
using test::MagneticRecord;

class Troubles {
  public:
    explicit Troubles(std::uint64_t seed) : random_(seed) {}

    MagnetometerRange iron() {
        const double size = random_.uniform(0.15, 0.5);
        MagnetometerRange range{size * random_.uniform(-3.0, 3.0),
                                size * random_.uniform(-3.0, 3.0), size * random_.uniform(0.8, 1.2),
                                size * random_.uniform(0.8, 1.2), random_.uniform(-0.3, 0.3)};
        if (happens(0.3)) range.range_y = -range.range_y;
        return range;
    }
    // What the file says of it: nothing, or nearly the truth, or what was true before.
    std::optional<MagnetometerRange> believed(const MagnetometerRange& truth) {
        if (happens(0.3)) return std::nullopt;
        const double off = happens(0.5) ? 0.01 : random_.uniform(0.02, 0.3);
        MagnetometerRange range = truth;
        const double size = std::abs(truth.range_x);
        range.centre_x += off * size * random_.normal();
        range.centre_y += off * size * random_.normal();
        range.range_x *= 1.0 + 0.5 * off * random_.normal();
        range.range_y *= 1.0 + 0.5 * off * random_.normal();
        range.correlation += 0.3 * off * random_.normal();
        return range;
    }
    MagneticBench bench(const MagnetometerRange& truth) {
        MagneticBench bench{.truth = truth, .turns = turns()};
        bench.vertical = random_.uniform(-0.5, 0.5);
        bench.speed_deg_s = random_.uniform(20.0, 120.0);
        bench.unevenness = random_.uniform(0.0, 0.7);
        bench.noise = random_.uniform(0.001, 0.04);
        bench.correlated = happens(0.4) ? random_.uniform(0.0, 0.03) : 0.0;
        bench.correlation_s = random_.uniform(0.1, 3.0);
        bench.step = happens(0.3) ? random_.uniform(0.0, 0.1) : 0.0;
        bench.clip = happens(0.1) ? random_.uniform(0.2, 1.1) : 1e9;
        bench.burst = happens(0.2) ? random_.uniform(-2.0, 2.0) : 0.0;
        bench.burst_from = static_cast<std::size_t>(random_.uniform(50.0, 500.0));
        bench.burst_length = static_cast<std::size_t>(random_.uniform(1.0, 60.0));
        bench.gradient = happens(0.4) ? random_.uniform(0.0, 0.3) : 0.0;
        bench.third_wave = happens(0.2) ? random_.uniform(0.0, 0.1) : 0.0;
        bench.other_turns = happens(0.2) ? random_.uniform(0.0, 0.3) : 0.0;
        bench.tilt = happens(0.2) ? random_.uniform(0.0, 0.15) : 0.0;
        bench.drift_deg_s = happens(0.2) ? random_.uniform(-0.5, 0.5) : 0.0;
        bench.fade_per_s = happens(0.2) ? random_.uniform(-0.003, 0.003) : 0.0;
        judge(bench);
        return bench;
    }
    void spoil(SampleSet& set) {
        for (std::size_t i = 0; happens(0.1) && i < set.reports.size(); i += 37) {
            set.reports[i].magnetic_field->x = happens(0.5)
                                                   ? std::numeric_limits<double>::quiet_NaN()
                                                   : random_.uniform(-5.0, 5.0);
        }
        if (!happens(0.1) || set.reports.size() < 100) return;
        const auto begin =
            set.reports.begin() + static_cast<std::ptrdiff_t>(random_.uniform(
                                      0.0, 0.7 * static_cast<double>(set.reports.size())));
        set.reports.erase(begin, begin + 25);
    }

  private:
    bool happens(double chance) { return random_.uniform() < chance; }
    std::vector<double> turns() {
        if (happens(0.2)) return {random_.uniform(-1.5, 1.5)};
        std::vector<double> turns;
        const double each = happens(0.5) ? 2.0 : random_.uniform(0.3, 4.0);
        for (int i = 0; i < 1 + static_cast<int>(random_.uniform(0.0, 4.0)); ++i) {
            turns.push_back(i % 2 == 0 ? each : -each);
        }
        return turns;
    }
    void judge(MagneticBench& bench) {
        bench.has_gyro = !happens(0.25);
        bench.has_wheels = happens(0.4);
        bench.gyro_scale = random_.uniform(0.95, 1.05);
        bench.gyro_bias_deg_s = random_.uniform(-1.5, 1.5);
        bench.gyro_noise_deg_s = random_.uniform(0.01, 0.5);
    }

    Random random_;
};

// How many were accepted and are truly worse.
int worseCompasses(int calibrations, std::uint64_t seed) {
    Troubles troubles(seed);
    std::array<int, 4> verdicts{};
    int worse = 0;
    for (int i = 0; i < calibrations; ++i) {
        const MagnetometerRange truth = troubles.iron();
        Vehicle vehicle{};
        vehicle.magnetometer = troubles.believed(truth);
        const MagneticBench bench = troubles.bench(truth);
        std::vector sets{MagneticRecord(bench, 1000 * seed + static_cast<std::uint64_t>(i)).set};
        troubles.spoil(sets[0]);
        const MagnetometerCalibration found = calibrateMagnetometer(sets, vehicle);
        ++verdicts.at(static_cast<std::size_t>(found.calibration.verdict));
        EXPECT_FALSE(found.calibration.reason.empty());
        if (found.calibration.verdict != Verdict::kAccepted) continue;
        const auto changed = calibrated(vehicle, found.calibration);
        EXPECT_TRUE(changed);
        if (!changed) continue;
        const MagnetometerRange old = vehicle.magnetometer.value_or(MagnetometerRange{});
        const double before = headingErrorOverCircle_rad(old, truth);
        const double after = headingErrorOverCircle_rad(*changed->magnetometer, truth);
        if (after <= before) continue;
        ++worse;
        std::printf("calibration %d: off by %.2f deg before, %.2f\n", i, degFromRad(before),
                    degFromRad(after));
    }
    std::printf("accepted %d, unchanged %d, not proven %d, refused %d, worse %d\n", verdicts[0],
                verdicts[1], verdicts[2], verdicts[3], worse);
    EXPECT_GT(verdicts[0], calibrations / 20);
    return worse;
}

TEST(Magnetometer, NeverAcceptsAWorseSet) { EXPECT_EQ(worseCompasses(25, 1), 0); }
TEST(Magnetometer, DISABLED_NeverAcceptsAWorseSetInAThousand) {
    EXPECT_EQ(worseCompasses(1000, 2), 0);
}
TEST(Magnetometer, DISABLED_NeverAcceptsAWorseSetInTenThousand) {
    EXPECT_EQ(worseCompasses(10000, 3), 0);
}

}  // namespace
}  // namespace hedr
