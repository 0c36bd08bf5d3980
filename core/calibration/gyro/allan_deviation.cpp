#include "core/calibration/gyro/allan_deviation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/calibration/distributions.h"

namespace hedr {

namespace {

constexpr std::size_t kFewestToIdentify = 64;  // averages
constexpr std::size_t kMostToIdentify = 65536;
constexpr int kWhitest = 2;
constexpr int kReddest = -2;

// The sum of all rates before each, about their mean: else a large mean would eat up the digits.
std::vector<double> anglesOf(std::span<const double> rates) {
    const double mean =
        std::accumulate(rates.begin(), rates.end(), 0.0) / static_cast<double>(rates.size());
    std::vector<double> angles(rates.size() + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        sum += rates[i] - mean;
        angles[i + 1] = sum;
    }
    return angles;
}

// Four sums at once: a single one would wait for each addition to end.
double sumOfSquaredDifferences(const double* x, std::size_t terms, std::size_t m) {
    constexpr std::size_t kLanes = 4;
    std::array<double, kLanes> sums{};
    const std::size_t whole = terms - terms % kLanes;
    for (std::size_t i = 0; i < whole; i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const std::size_t k = i + lane;
            const double d = (x[k + 2 * m] - x[k + m]) - (x[k + m] - x[k]);
            sums[lane] += d * d;
        }
    }
    double sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    for (std::size_t k = whole; k < terms; ++k) {
        const double d = (x[k + 2 * m] - x[k + m]) - (x[k + m] - x[k]);
        sum += d * d;
    }
    return sum;
}

// Piece by piece, all factors of one after another, so that memory is read as seldom as possible.
std::vector<double> sumsOfSquaredDifferences(const std::vector<double>& angles,
                                             std::span<const std::size_t> factors) {
    constexpr std::size_t kPiece = 8192;  // fits into the processor's caches
    std::vector<double> sums(factors.size());
    for (std::size_t begin = 0; begin < angles.size(); begin += kPiece) {
        for (std::size_t f = 0; f < factors.size(); ++f) {
            const std::size_t terms = angles.size() - 2 * factors[f];
            if (begin >= terms) continue;
            sums[f] += sumOfSquaredDifferences(angles.data() + begin,
                                               std::min(kPiece, terms - begin), factors[f]);
        }
    }
    return sums;
}

double lagOneCorrelation(const std::vector<double>& values) {
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double d = values[i] - mean;
        square += d * d;
        if (i > 0) product += d * (values[i - 1] - mean);
    }
    return square > 0.0 ? product / square : 0.0;
}

std::vector<double> averagesOf(const std::vector<double>& angles, std::size_t m) {
    std::vector<double> averages(std::min((angles.size() - 1) / m, kMostToIdentify));
    for (std::size_t i = 0; i < averages.size(); ++i)
        averages[i] = angles[(i + 1) * m] - angles[i * m];
    return averages;
}

// By the lag-1 autocorrelation of averages that do not overlap; differenced until they are
// stationary.
int noiseExponentOf(std::vector<double> averages) {
    constexpr double kStationary = 0.25;
    for (int differences = 0;; ++differences) {
        const double r = lagOneCorrelation(averages);
        const double delta = r / (1.0 + r);
        if (delta < kStationary || differences == 2) {
            const double exponent = -2.0 * (delta + differences);
            return std::clamp(static_cast<int>(std::lround(exponent)), kReddest, kWhitest);
        }
        for (std::size_t i = 0; i + 1 < averages.size(); ++i)
            averages[i] = averages[i + 1] - averages[i];
        averages.pop_back();
    }
}

// Of `n` angles at factor `m`.
double degreesOfFreedom(int noise_exponent, double n, double m) {
    switch (noise_exponent) {
        case 2:
            return (n + 1.0) * (n - 2.0 * m) / (2.0 * (n - m));
        case 1:
            return std::exp(std::sqrt(std::log((n - 1.0) / (2.0 * m)) *
                                      std::log((2.0 * m + 1.0) * (n - 1.0) / 4.0)));
        case 0:
            return (3.0 * (n - 1.0) / (2.0 * m) - 2.0 * (n - 2.0) / n) * 4.0 * m * m /
                   (4.0 * m * m + 5.0);
        case -1:
            return m == 1.0 ? 2.0 * (n - 2.0) * (n - 2.0) / (2.3 * n - 4.9)
                            : 5.0 * n * n / (4.0 * m * (n + 3.0 * m));
        default:
            return (n - 2.0) / m * ((n - 1.0) * (n - 1.0) - 3.0 * m * (n - 1.0) + 4.0 * m * m) /
                   ((n - 3.0) * (n - 3.0));
    }
}

Interval bandOf(const AllanPoint& point) {
    const double variance = point.deviation * point.deviation * point.degrees_of_freedom;
    return {std::sqrt(variance / chiSquaredQuantile(0.975, point.degrees_of_freedom)),
            std::sqrt(variance / chiSquaredQuantile(0.025, point.degrees_of_freedom))};
}

}  // namespace

std::vector<std::size_t> octaveFactors(std::size_t rates) {
    std::vector<std::size_t> factors;
    for (std::size_t m = 1; 2 * m <= rates; m *= 2) factors.push_back(m);
    return factors;
}

std::vector<AllanPoint> allanDeviation(std::span<const double> rates, double period_s,
                                       std::span<const std::size_t> factors) {
    const std::vector<double> angles = anglesOf(rates);
    const std::vector<double> sums = sumsOfSquaredDifferences(angles, factors);
    std::vector<AllanPoint> points;
    // Slow noise is redder than fast one. From few averages it could seem otherwise, and the band
    // would be too narrow.
    int exponent = kWhitest;
    for (std::size_t f = 0; f < factors.size(); ++f) {
        const std::size_t m = factors[f];
        assert(m >= 1 && 2 * m <= rates.size());
        const double length = static_cast<double>(m);
        AllanPoint point{.factor = m, .tau_s = length * period_s};
        point.terms = rates.size() - 2 * m + 1;
        point.deviation = std::sqrt(sums[f] / (2.0 * static_cast<double>(point.terms))) / length;
        const bool enough = rates.size() / m >= kFewestToIdentify || f == 0;
        if (enough) exponent = std::min(exponent, noiseExponentOf(averagesOf(angles, m)));
        point.noise_exponent = exponent;
        point.degrees_of_freedom =
            std::max(1.0, degreesOfFreedom(exponent, static_cast<double>(angles.size()), length));
        point.band = bandOf(point);
        points.push_back(point);
    }
    return points;
}

}  // namespace hedr
