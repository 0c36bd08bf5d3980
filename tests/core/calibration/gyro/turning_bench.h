#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/calibration/gyro/gyro_scale.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr::test {

// A robot that somebody turns by hand, from mark to mark.
struct TurningBench {
    std::vector<int> turns{3, -3, 3, -3};
    double scale = 1.02;      // true per reported rate, mean of both ways
    double difference = 0.0;  // counter-clockwise less clockwise
    double mark_deg = 1.5;    // standard deviation
    double bias_deg_s = 0.4;
    double ramp_deg_s2 = 0.0;  // of the bias
    double noise_deg_s = 0.1;  // of a reading
    double speed_deg_s = 70.0;
    double range_deg_s = 1e9;
    double stand_s = 5.0;
    double rate_hz = 25.0;
    std::size_t bad_turn = 0;  // it stands beside the mark after it, from 1 on
    double bad_mark_deg = 0.0;
};

class BenchLog {
  public:
    BenchLog(const TurningBench& bench, std::uint64_t seed) : bench_(bench), random_(seed) {
        double beside_deg = bench.mark_deg * random_.normal();
        stand(bench.stand_s);
        for (std::size_t i = 0; i < bench.turns.size(); ++i) {
            double next_deg = bench.mark_deg * random_.normal();
            if (i + 1 == bench.bad_turn) next_deg += bench.bad_mark_deg;
            turn(360.0 * bench.turns[i] + next_deg - beside_deg);
            beside_deg = next_deg;
            stand(bench.stand_s);
        }
    }

    void stand(double time_s) {
        for (double until_s = time_s_ + time_s; time_s_ < until_s;) add(0.0);
    }
    // Faster in the middle, with the unsteadiness of a hand.
    void turn(double angle_deg) {
        const double span_s = 1.4 * std::abs(angle_deg) / bench_.speed_deg_s + 0.5;
        const auto steps = static_cast<int>(std::ceil(span_s * bench_.rate_hz));
        std::vector<double> shares;
        CorrelatedNoise hand(0.5, 1.0 / bench_.rate_hz);
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double way = (i + 0.5) / steps;
            shares.push_back(std::min(1.0, 6.0 * std::min(way, 1.0 - way)) *
                             (1.0 + 0.15 * hand.next(random_)));
            sum += shares.back();
        }
        for (const double share : shares) add(angle_deg * bench_.rate_hz * share / sum);
    }
    void add(double rate_deg_s) {
        const double scale = bench_.scale + std::copysign(0.5 * bench_.difference, rate_deg_s);
        const double reading_deg_s = rate_deg_s / scale + bench_.bias_deg_s +
                                     bench_.ramp_deg_s2 * time_s_ +
                                     bench_.noise_deg_s * random_.normal();
        time_s_ += 1.0 / bench_.rate_hz;
        set.reports.push_back({.robot_time_s = time_s_,
                               .gyro = GyroRate{radFromDeg(std::clamp(
                                   reading_deg_s, -bench_.range_deg_s, bench_.range_deg_s))}});
    }

    SampleSet set{};

  private:
    TurningBench bench_;
    Random random_;
    double time_s_ = 0.0;
};

inline SampleSet logOf(const TurningBench& bench, std::uint64_t seed) {
    return BenchLog(bench, seed).set;
}

inline GyroScale scaleOf(const TurningBench& bench, std::uint64_t seed, const Vehicle& vehicle = {},
                         const GyroScaleOptions& options = {}) {
    const std::vector sets{logOf(bench, seed)};
    return calibrateGyroScale(sets, vehicle, options);
}

inline const std::vector<int> kTwoEach{3, -3, 3, -3};
inline const std::vector<int> kTwoAndTwo{3, 3, -3, -3};
inline const std::vector<int> kFourEach{2, -2, 2, -2, 2, -2, 2, -2};
inline const std::vector<int> kFiveAndFive{1, 1, 1, 1, 1, -1, -1, -1, -1, -1};

}  // namespace hedr::test
