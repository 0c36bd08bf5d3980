#include "core/calibration/gyro/gyro_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/gyro/gyro_range.h"
#include "core/calibration/gyro_samples.h"
#include "core/calibration/median.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr const char* kProcedureName = "allan";
constexpr std::size_t kFewestNoiseReadings = 256;
constexpr double kShortestRecord_s = 30.0;
constexpr double kGoodRecord_s = 7200.0;    // two hours tell a bias instability at some 100 s
constexpr double kOutlierDeviations = 8.0;  // of the median one
constexpr double kMedianToSigma = 1.4826;
constexpr double kMostMissing = 0.02;
constexpr double kTenMinutes_s = 600.0;
constexpr double kUsualNoise_rad_s_sqrthz = radFromDeg(0.05);  // that the filters take

// Lone readings far from all others take the place of the one before. Their number.
std::size_t withoutOutliers(std::vector<double>& rates) {
    const double middle = medianOf(rates);
    std::vector<double> distances;
    distances.reserve(rates.size());
    for (const double rate : rates) distances.push_back(std::abs(rate - middle));
    const double limit = kOutlierDeviations * kMedianToSigma * medianOf(distances);
    std::size_t outliers = 0;
    for (std::size_t i = 0; i < rates.size() && limit > 0.0; ++i) {
        if (std::abs(rates[i] - middle) <= limit) continue;
        rates[i] = i > 0 ? rates[i - 1] : middle;
        ++outliers;
    }
    return outliers;
}

bool wheelsMoved(std::span<const SensorReport> reports) {
    const Odometry* first = nullptr;
    for (const SensorReport& report : reports) {
        if (std::holds_alternative<std::monostate>(report.odometry)) continue;
        if (first && report.odometry != *first) return true;
        if (!first) first = &report.odometry;
    }
    return false;
}

// Why these readings are no basis; empty where they are.
std::string objectionTo(const GyroSamples& gyro, std::span<const SensorReport> reports) {
    const auto [least, most] = std::ranges::minmax_element(
        gyro.samples, {}, [](const GyroSample& sample) { return sample.rate_rad_s; });
    if (least->rate_rad_s == most->rate_rad_s)
        return "All readings of the gyro are the same. Check that it is connected.";
    if (wheelsMoved(reports)) return "The wheels moved: let the robot stand for the whole record.";
    if (std::string clipped = complaintAboutClipped(gyro.samples); !clipped.empty()) return clipped;
    if (gyro.duration_s() < kShortestRecord_s)
        return "The record of " + shortNumber(gyro.duration_s(), 3) +
               " s is too short: let the robot stand for 10 minutes.";
    if (gyro.samples.size() < kFewestNoiseReadings)
        return std::to_string(gyro.samples.size()) + " readings are too few, " +
               std::to_string(kFewestNoiseReadings) + " are needed: let the robot stand longer.";
    const double missing =
        static_cast<double>(gyro.broken + gyro.gaps) / static_cast<double>(gyro.samples.size());
    if (missing > kMostMissing)
        return "Too many readings are missing or broken: record again over a better link.";
    return {};
}

double degreesPerHour(double rad_s) { return degFromRad(rad_s) * 3600.0; }

// The classes are those of makers' overviews (VectorNav, "Inertial Navigation Primer", chapter 3):
// by the bias instability, and where that is not told by the noise.
std::string gradeOf(const GyroNoiseFit& fit) {
    const NoiseCoefficient& b = fit.instability_rad_s;
    const double per_hour = degreesPerHour(b.found ? b.found->value : b.interval.high);
    if (per_hour > 10.0) return "a usual cheap gyro";
    if (per_hour > 1.0) return b.found ? "a good industrial gyro" : "an industrial gyro or better";
    return "a gyro of tactical grade";
}

std::string verdictWords(const GyroNoiseFit& fit) {
    const double noise = fit.angle_walk_rad_s_sqrthz.found->value;
    const NoiseCoefficient& b = fit.instability_rad_s;
    std::string words =
        "This is " + gradeOf(fit) + ": its noise alone makes the heading unsure by ";
    words += shortNumber(degFromRad(noise * std::sqrt(kTenMinutes_s))) + "° in 10 minutes";
    const double held = degFromRad((b.found ? b.found->value : b.interval.high) * kTenMinutes_s);
    words += b.found ? ", a bias that wanders by about " : ", a bias that wanders by at most ";
    return words + shortNumber(held) + "°.";
}

void addFigures(const GyroNoiseFit& fit, Calibration& calibration) {
    const auto add = [&](const char* name, const NoiseCoefficient& c, const char* unit) {
        if (c.found) {
            calibration.figures.push_back({name, c.found->value, unit, c.interval});
        } else {
            calibration.figures.push_back(
                {std::string(name) + ", at most", c.interval.high, unit, std::nullopt});
        }
    };
    add("Angle random walk N", fit.angle_walk_rad_s_sqrthz, "rad/s/sqrt(Hz)");
    add("Bias instability B", fit.instability_rad_s, "rad/s");
    add("Rate random walk K", fit.rate_walk_rad_s_sqrts, "rad/s/sqrt(s)");
}

void addRemarks(const GyroNoiseFit& fit, double duration_s, Calibration& calibration) {
    calibration.remarks.push_back(verdictWords(fit));
    const std::string minutes = shortNumber(duration_s / 60.0, 3);
    if (!fit.instability_rad_s.found)
        calibration.remarks.push_back("A record of " + minutes +
                                      " minutes is too short to tell how stable the bias is; two "
                                      "hours usually do.");
    if (!fit.rate_walk_rad_s_sqrts.found)
        calibration.remarks.push_back("A record of " + minutes +
                                      " minutes does not tell how far the bias walks; only a bound "
                                      "is known.");
}

EvidencePlot plotOf(const std::vector<AllanPoint>& points, const GyroNoiseFit& fit) {
    EvidencePlot plot{.title = "How much the mean rate still varies",
                      .x = {"Averaging time", "s", true},
                      .y = {"Allan deviation", "rad/s", true}};
    EvidenceSeries band{.name = "95 % band", .shape = EvidenceSeries::Shape::kBand};
    EvidenceSeries measured{.name = "measured", .shape = EvidenceSeries::Shape::kDots};
    EvidenceSeries model{.name = "fitted", .shape = EvidenceSeries::Shape::kLine};
    for (const AllanPoint& point : points) {
        for (EvidenceSeries* each : {&band, &measured, &model}) each->x.push_back(point.tau_s);
        band.y.push_back(point.band.low);
        band.y_high.push_back(point.band.high);
        measured.y.push_back(point.deviation);
        model.y.push_back(fit.deviation(point.tau_s));
    }
    plot.series = {std::move(band), std::move(model), std::move(measured)};
    return plot;
}

// Deviation that the filters expect of a vehicle file's two numbers.
double expectedDeviation(double noise_rad_s_sqrthz, double walk_rad_s_sqrts, double tau_s) {
    const double noise = noise_rad_s_sqrthz > 0.0 ? noise_rad_s_sqrthz : kUsualNoise_rad_s_sqrthz;
    return std::sqrt(noise * noise / tau_s + walk_rad_s_sqrts * walk_rad_s_sqrts * tau_s / 3.0);
}

// The deviations of the later half against what the old numbers and those of the earlier half
// expect: each octave is a part, its error the logarithm of the ratio in units of its own
// uncertainty.
std::optional<Proof> proofOfHalves(std::span<const double> rates, double period_s,
                                   const Vehicle& believed) {
    constexpr double kFewestDegrees = 10.0;
    constexpr double kMostDegrees = 400.0;  // nobody knows a spectrum better than to some percent
    const std::size_t half = rates.size() / 2;
    const auto first = allanDeviation(rates.first(half), period_s, octaveFactors(half));
    const auto fit = fitGyroNoise(first, period_s);
    if (!fit || !fit->angle_walk_rad_s_sqrthz.found) return std::nullopt;
    const double noise = fit->angle_walk_rad_s_sqrthz.found->value;
    const auto& walk = fit->rate_walk_rad_s_sqrts.found;
    const double old_walk = believed.gyro_bias_walk_rad_s_sqrts;
    std::vector<HeldOutError> parts;
    for (const AllanPoint& point :
         allanDeviation(rates.subspan(half), period_s, octaveFactors(half))) {
        if (point.tau_s < fit->fitted_from_s || point.degrees_of_freedom < kFewestDegrees) continue;
        const auto error = [&](double with_noise, double with_walk) {
            return std::log(point.deviation /
                            expectedDeviation(with_noise, with_walk, point.tau_s)) *
                   std::sqrt(2.0 * std::min(kMostDegrees, point.degrees_of_freedom));
        };
        parts.push_back({error(believed.gyro_noise_rad_s_sqrthz, old_walk),
                         error(noise, walk ? walk->value : old_walk)});
    }
    return proofOf(parts, "expected noise, off by its own uncertainty", "times");
}

FoundParameter foundNoise(std::string_view key, const Estimate& now, const Vehicle& believed) {
    const double old = vehicleNumber(believed, key).value_or(0.0);
    return {key, old > 0.0 ? std::optional(old) : std::nullopt, now};
}

// As the vehicle's filters take them.
std::vector<double> scaledRates(const GyroSamples& gyro, double scale) {
    std::vector<double> rates = gyro.rates_rad_s();
    for (double& rate : rates) rate *= scale;
    return rates;
}

std::vector<CalibrationStep> stepsFor(double duration_s) {
    return {{"Let it stand", "On a firm floor, motors off; two hours tell most.",
             duration_s >= kGoodRecord_s},
            {"Look at the verdict", "The longer it stands, the more is known.", false}};
}

}  // namespace

GyroNoiseResult calibrateGyroNoise(std::span<const SensorReport> reports, const Vehicle& believed) {
    GyroNoiseResult result;
    Calibration& calibration = result.calibration;
    calibration.procedure = kProcedureName;
    const auto gyro = gyroSamplesOf(reports);
    calibration.steps = stepsFor(gyro ? gyro->duration_s() : 0.0);
    if (!gyro) {
        calibration = refused(std::move(calibration), "No readings of a gyro have come.");
        return result;
    }
    calibration.progress.share = std::min(1.0, gyro->duration_s() / kGoodRecord_s);
    const std::string objection = objectionTo(*gyro, reports);
    if (!objection.empty()) {
        calibration = refused(std::move(calibration), objection);
        return result;
    }
    std::vector<double> rates = scaledRates(*gyro, believed.gyro_scale);
    const std::size_t outliers = withoutOutliers(rates);
    if (outliers > 0)
        calibration.remarks.push_back(std::to_string(outliers) +
                                      " readings far from all others were left out.");
    result.deviations = allanDeviation(rates, gyro->period_s, octaveFactors(rates.size()));
    result.fit = fitGyroNoise(result.deviations, gyro->period_s);
    if (!result.fit || !result.fit->angle_walk_rad_s_sqrthz.found) {
        calibration = refused(std::move(calibration),
                              "The readings do not look like the noise of a gyro that stands.");
        return result;
    }
    addFigures(*result.fit, calibration);
    addRemarks(*result.fit, gyro->duration_s(), calibration);
    calibration.plots.push_back(plotOf(result.deviations, *result.fit));
    calibration.found.push_back(foundNoise("gyro_noise_rad_s_sqrthz",
                                           *result.fit->angle_walk_rad_s_sqrthz.found, believed));
    if (const auto& walk = result.fit->rate_walk_rad_s_sqrts.found)
        calibration.found.push_back(foundNoise("gyro_bias_walk_rad_s_sqrts", *walk, believed));
    calibration.proof = proofOfHalves(rates, gyro->period_s, believed);
    calibration = judged(std::move(calibration));
    return result;
}

}  // namespace hedr
