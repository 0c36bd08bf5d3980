#include "core/calibration/gyro/gyro_bias_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/calibration/gyro/gyro_stretch.h"
#include "core/calibration/median.h"

namespace hedr {

namespace {

constexpr double kOutlierSigmas = 5.0;  // a normal reading is that far once in two million
constexpr double kDeviationPerMedianReading = 1.4826;
constexpr double kLongestWeightPeriods = 3.0;  // one reading cannot speak for a longer gap

// So long that noise which goes on for a while is over within one; enough of them for an error.
constexpr double kShortestPart_s = 3.5;
constexpr double kFewestParts = 6.0;
constexpr double kMostParts = 12.0;

constexpr double kNoiseOver_s = 0.5;
constexpr double kDegreesPerMean = 0.5;  // of freedom, in the trimmed noise

constexpr double kShortestNeeded_s = 20.0;
constexpr double kLongestNeeded_s = 300.0;  // longer, the bias itself wanders
constexpr double kFirstAllan_s = 5.0;
constexpr double kFewestMeans = 6.0;
constexpr double kSureDeviations = 1.64;

struct Usual {
    double rate_rad_s = 0.0;
    double deviation_rad_s = 0.0;
};

// Where most readings are equal, the next value is no outlier.
Usual usualOf(std::span<const GyroSample> samples) {
    std::vector<double> values;
    values.reserve(samples.size());
    for (const GyroSample& sample : samples) values.push_back(sample.rate_rad_s);
    const double median = medianOf(values);
    double smallest = 0.0;
    for (double& value : values) {
        value = std::abs(value - median);
        if (value > 0.0 && (smallest == 0.0 || value < smallest)) smallest = value;
    }
    return {median, std::max(kDeviationPerMedianReading * medianOf(std::move(values)), smallest)};
}

// `kept`: readings that count are added.
GyroBiasPart biasPartOf(std::span<const GyroSample> samples, double period_s, GyroStretch& kept) {
    const Usual usual = usualOf(samples);
    GyroBiasPart part;
    double turn_rad = 0.0;
    for (const GyroSample& sample : samples) {
        const double away_rad_s = std::abs(sample.rate_rad_s - usual.rate_rad_s);
        if (away_rad_s > kOutlierSigmas * usual.deviation_rad_s) {
            ++part.outliers;
            continue;
        }
        kept.add(sample);
        const double weight_s = std::min(sample.dt_s, kLongestWeightPeriods * period_s);
        turn_rad += sample.rate_rad_s * weight_s;
        part.span_s += weight_s;
    }
    part.mean_rad_s = turn_rad / part.span_s;
    part.middle_s = 0.5 * (samples.front().t_s + samples.back().t_s);
    return part;
}

// A straight line through the parts' means, all with the same weight.
void fitBiasLine(GyroBiasFit& fit) {
    const double n = static_cast<double>(fit.parts.size());
    double mean = 0.0;
    double middle_s = 0.0;
    for (const GyroBiasPart& part : fit.parts) {
        mean += part.mean_rad_s / n;
        middle_s += part.middle_s / n;
    }
    double times = 0.0;
    double products = 0.0;
    for (const GyroBiasPart& part : fit.parts) {
        times += (part.middle_s - middle_s) * (part.middle_s - middle_s);
        products += (part.middle_s - middle_s) * (part.mean_rad_s - mean);
    }
    const double drift = products / times;
    double squares = 0.0;
    for (const GyroBiasPart& part : fit.parts) {
        const double rest = part.mean_rad_s - mean - drift * (part.middle_s - middle_s);
        squares += rest * rest;
    }
    const double degrees = n - 2.0;
    fit.mean_rad_s = {mean, std::sqrt(squares / degrees / n), degrees};
    fit.drift_rad_s2 = {drift, std::sqrt(squares / degrees / times), degrees};
}

// A density grows with the root of a sum of squares, so its relative error is half of theirs.
Estimate densityIn(const GyroStretch& stretch) {
    const double noise = stretch.noise_rad_s_sqrthz(kNoiseOver_s);
    const double means = std::min(stretch.duration_s(), GyroStretch::kNoiseFrom_s) / kNoiseOver_s;
    const double degrees = std::max(1.0, kDegreesPerMean * means);
    return {noise, noise / std::sqrt(2.0 * degrees), degrees};
}

}  // namespace

GyroBiasFit fitGyroBias(std::span<const GyroSample> standing, double period_s) {
    assert(standing.size() >= kFewestGyroBiasReadings);
    GyroBiasFit fit;
    const double time_s = standing.back().t_s - standing.front().t_s;
    const auto parts =
        static_cast<std::size_t>(std::clamp(time_s / kShortestPart_s, kFewestParts, kMostParts));
    const std::size_t each = standing.size() / parts;
    fit.parts.reserve(parts);
    GyroStretch kept;
    for (std::size_t part = 0; part < parts; ++part) {
        fit.parts.push_back(biasPartOf(standing.subspan(part * each, each), period_s, kept));
        fit.outliers += fit.parts.back().outliers;
    }
    fitBiasLine(fit);
    fit.noise_rad_s_sqrthz = densityIn(kept);
    const double rounding = kept.coarseStep_rad_s() / std::sqrt(12.0);
    fit.mean_rad_s.standard_error = std::hypot(fit.mean_rad_s.standard_error, rounding);
    return fit;
}

double standingNeeded_s(std::span<const GyroSample> standing, double noise_rad_s_sqrthz,
                        double wanted_rad_s) {
    GyroStretch stretch;
    for (const GyroSample& sample : standing) stretch.add(sample);
    const double variance = noise_rad_s_sqrthz * noise_rad_s_sqrthz;
    double needed_s = variance / (wanted_rad_s * wanted_rad_s);
    for (double over_s = kFirstAllan_s; over_s < needed_s; over_s *= 2.0) {
        const double means = stretch.duration_s() / over_s;
        if (means < kFewestMeans) break;
        const double density = stretch.noise_rad_s_sqrthz(over_s, stretch.duration_s());
        const double sure = std::exp(kSureDeviations * std::sqrt(2.0 / (kDegreesPerMean * means)));
        if (density * density > 2.0 * variance * sure) needed_s = over_s;
    }
    return std::clamp(needed_s, kShortestNeeded_s, kLongestNeeded_s);
}

}  // namespace hedr
