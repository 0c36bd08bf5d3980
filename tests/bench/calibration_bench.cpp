#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "core/calibration/gyro/allan_deviation.h"
#include "core/simulation/random.h"

namespace hedr {
namespace {

constexpr double kPeriod_s = 0.01;

const std::vector<double>& noise() {
    static const std::vector<double> kRates = [] {
        Random random(1);
        std::vector<double> rates(10'000'000);
        for (double& rate : rates) rate = random.normal();
        return rates;
    }();
    return kRates;
}

void allanOfTenMillion(benchmark::State& state) {
    const std::vector<std::size_t> factors = octaveFactors(noise().size());
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(allanDeviation(noise(), kPeriod_s, factors));
}
BENCHMARK(allanOfTenMillion)->Unit(benchmark::kMillisecond);

// The definition on sums so far, deviations only: no bands, no kind of noise.
void plainAllanOfTenMillion(benchmark::State& state) {
    const std::vector<double>& rates = noise();
    for ([[maybe_unused]] auto _ : state) {
        std::vector<double> sums(rates.size() + 1, 0.0);
        for (std::size_t i = 0; i < rates.size(); ++i) sums[i + 1] = sums[i] + rates[i];
        for (const std::size_t m : octaveFactors(rates.size())) {
            double squares = 0.0;
            const std::size_t terms = rates.size() - 2 * m + 1;
            for (std::size_t i = 0; i < terms; ++i) {
                const double second = sums[i + 2 * m] - 2.0 * sums[i + m] + sums[i];
                squares += second * second;
            }
            const auto factor = static_cast<double>(m);
            benchmark::DoNotOptimize(
                std::sqrt(squares / (2.0 * factor * factor * static_cast<double>(terms))));
        }
    }
}
BENCHMARK(plainAllanOfTenMillion)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedr
