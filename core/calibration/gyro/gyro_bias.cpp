#include "core/calibration/gyro/gyro_bias.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/calibration/gyro/gyro_bias_evidence.h"
#include "core/calibration/gyro/gyro_range.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"
#include "core/robot/motion.h"

namespace hedr {

namespace {

constexpr std::string_view kGyroBiasKey = "gyro_bias_rad_s";
constexpr double kShortestStanding_s = 10.0;
constexpr double kSureOfBetter = 0.99;
constexpr double kMostEqualShare = 0.99;
constexpr double kMostChange_rad_s = radFromDeg(0.005);  // from the mean to the end
constexpr double kSureOfChange = 0.99;
constexpr double kShortestWhileChanging_s = 15.0;

std::span<const GyroSample> samplesIn(const GyroSamples& gyro, const StandingTime& time) {
    const auto earlier = [](const GyroSample& sample, double t_s) { return sample.t_s < t_s; };
    const auto begin =
        std::lower_bound(gyro.samples.begin(), gyro.samples.end(), time.begin_s, earlier);
    const auto end = std::lower_bound(begin, gyro.samples.end(), time.end_s, earlier);
    return {begin, end};
}

// The last one where several are as long.
StandingTime longestOf(const std::vector<StandingTime>& times) {
    StandingTime longest;
    for (const StandingTime& time : times) {
        if (time.duration_s() >= longest.duration_s()) longest = time;
    }
    return longest;
}

std::optional<double> temperatureWhile_c(std::span<const SensorReport> reports,
                                         const StandingTime& time) {
    double sum_c = 0.0;
    double count = 0.0;
    for (const SensorReport& report : reports) {
        const bool counts = report.temperature_c && std::isfinite(*report.temperature_c) &&
                            report.robot_time_s >= time.begin_s &&
                            report.robot_time_s <= time.end_s;
        if (!counts) continue;
        sum_c += *report.temperature_c;
        count += 1.0;
    }
    return count > 0.0 ? std::optional(sum_c / count) : std::nullopt;
}

// Of the readings as such; empty: none.
std::string complaintAbout(const GyroSamples& gyro) {
    std::string useless = complaintAboutBroken(gyro.samples.size(), gyro.broken);
    if (!useless.empty()) return useless;
    if (shareOfCommonest(gyro.samples) > kMostEqualShare) {
        return "The gyro readings are all equal: it does not answer, is at the end of its range, "
               "or is too coarse. Check it and its wiring.";
    }
    return {};
}

// Of how the robot stood; empty: none.
std::string complaintAbout(const GyroBias& bias, std::size_t readings) {
    if (bias.standing.duration_s() < kShortestStanding_s || readings < kFewestGyroBiasReadings) {
        const std::string need = "Let it stand for at least " + shortNumber(kShortestStanding_s) +
                                 " s, at 10 readings a second or more.";
        if (bias.state != Stillness::State::kMoves) return "It has not stood for long. " + need;
        return sentenceOf(bias.disturbances.back().sign) + ' ' + need;
    }
    const auto changed =
        std::find_if(bias.disturbances.begin(), bias.disturbances.end(),
                     [](const Disturbance& disturbance) { return disturbance.rate_changed; });
    if (changed != bias.disturbances.end()) {
        return sentenceOf(changed->sign) +
               " It has not come back to its old rate, so it turned before or after. Make sure "
               "that it stands, and start again.";
    }
    return {};
}

bool isChanging(const GyroBias& bias) {
    const Estimate& drift = bias.drift_rad_s2;
    const double change_rad_s = 0.5 * bias.standing.duration_s() * drift.value;
    return std::abs(change_rad_s) > kMostChange_rad_s &&
           !drift.interval(kSureOfChange).contains(0.0);
}

std::string complaintAbout(const GyroBias& bias, std::span<const GyroSample> standing) {
    if (isChanging(bias)) {
        return "The bias changes by " + shortNumber(degFromRad(60.0 * bias.drift_rad_s2.value)) +
               " °/s in a minute. Wait until the gyro is warm, or measure its warm-up.";
    }
    if (std::string clipped = complaintAboutClipped(standing); !clipped.empty()) return clipped;
    if (std::abs(bias.bias_rad_s.value) > kLargestGyroBias_rad_s) {
        return "The gyro reads " + shortNumber(degFromRad(bias.bias_rad_s.value)) +
               " °/s while the robot stands, too much for a bias. Check the gyro and its scale.";
    }
    return {};
}

// Every part is judged by the mean of the others, and by the old bias or none.
Proof driftProof(const GyroBiasFit& fit, double scale, double old_rad_s) {
    const double n = static_cast<double>(fit.parts.size());
    std::vector<HeldOutError> errors;
    errors.reserve(fit.parts.size());
    for (const GyroBiasPart& part : fit.parts) {
        const double others_rad_s = (n * fit.mean_rad_s.value - part.mean_rad_s) / (n - 1.0);
        errors.push_back({(scale * part.mean_rad_s - old_rad_s) * part.span_s,
                          scale * (part.mean_rad_s - others_rad_s) * part.span_s});
    }
    return proofOf(errors, "heading drift in each part of the time it stood", "rad");
}

Estimate scaledBy(const Estimate& estimate, double scale) {
    return {scale * estimate.value, std::abs(scale) * estimate.standard_error,
            estimate.degrees_of_freedom};
}

// A few parts may lie close together by luck, and tell too small an error; what the noise of the
// readings makes of their mean is known better.
bool isBeyondNoise(const GyroBias& bias) {
    const double error_rad_s =
        bias.noise_rad_s_sqrthz.value / std::sqrt(bias.standing.duration_s());
    const double old_rad_s = bias.calibration.found.front().was.value_or(0.0);
    return 0.5 * std::abs(bias.bias_rad_s.value - old_rad_s) >
           Estimate{0.0, error_rad_s}.margin(kSureOfBetter);
}

// What is found in the longest time of standing, so far as there is enough of it.
GyroBiasFit measureBias(GyroBias& bias, std::span<const GyroSample> samples, double period_s,
                        const Vehicle& believed, double wanted_rad_s) {
    if (samples.size() < kFewestGyroBiasReadings) return {};
    const double scale = believed.gyro_scale;
    GyroBiasFit fit = fitGyroBias(samples, period_s);
    bias.bias_rad_s = scaledBy(fit.mean_rad_s, scale);
    bias.drift_rad_s2 = scaledBy(fit.drift_rad_s2, scale);
    bias.noise_rad_s_sqrthz = scaledBy(fit.noise_rad_s_sqrthz, std::abs(scale));
    bias.needed_s =
        standingNeeded_s(samples, fit.noise_rad_s_sqrthz.value, wanted_rad_s / std::abs(scale));
    bias.calibration.found = {{kGyroBiasKey, believed.gyro_bias_rad_s, bias.bias_rad_s}};
    return fit;
}

// Of a bias that changes the end counts: halved until its mean still holds there.
GyroBiasFit measureBiasAtTheEnd(GyroBias& bias, const GyroSamples& gyro, const Vehicle& believed,
                                double wanted_rad_s) {
    const StandingTime whole = bias.standing;
    const auto measure = [&] {
        return measureBias(bias, samplesIn(gyro, bias.standing), gyro.period_s, believed,
                           wanted_rad_s);
    };
    GyroBiasFit fit = measure();
    if (isChanging(bias)) bias.changed_rad_s2 = bias.drift_rad_s2.value;
    while (isChanging(bias) && bias.standing.duration_s() > 2.0 * kShortestWhileChanging_s) {
        bias.standing.begin_s += 0.5 * bias.standing.duration_s();
        fit = measure();
    }
    bias.left_out_s = bias.standing.begin_s - whole.begin_s;
    return fit;
}

}  // namespace

GyroBias calibrateGyroBias(std::span<const SensorReport> reports, const Vehicle& believed,
                           const GyroBiasOptions& options) {
    GyroBias bias;
    Calibration& calibration = bias.calibration;
    calibration.procedure = "gyro-bias";
    calibration.steps = gyroBiasSteps(bias);
    const auto refuse = [&bias](std::string reason) {
        bias.calibration = refused(std::move(bias.calibration), std::move(reason));
        return bias;
    };
    const auto gyro = gyroSamplesOf(reports);
    if (!gyro) return refuse("No gyro readings came. Check that the robot sends them.");

    const Stillness stillness = stillnessIn(reports, *gyro, believed);
    bias.state = stillness.state();
    bias.disturbances = stillness.disturbances();
    bias.standing = longestOf(stillness.standing());
    const double wanted_rad_s = options.wanted_standard_error_rad_s;
    const GyroBiasFit fit = measureBiasAtTheEnd(bias, *gyro, believed, wanted_rad_s);
    const auto samples = samplesIn(*gyro, bias.standing);
    bias.temperature_c = temperatureWhile_c(reports, bias.standing);
    addEvidence(bias, *gyro, stillness, fit.outliers, believed.gyro_scale, wanted_rad_s);
    for (std::string complaint : {complaintAbout(*gyro), complaintAbout(bias, samples.size()),
                                  complaintAbout(bias, samples)}) {
        if (!complaint.empty()) return refuse(std::move(complaint));
    }
    calibration.proof =
        driftProof(fit, believed.gyro_scale, believed.gyro_bias_rad_s.value_or(0.0));
    calibration = judged(std::move(calibration));
    if (calibration.verdict == Verdict::kAccepted && !isBeyondNoise(bias)) {
        calibration.verdict = Verdict::kNotProven;
        calibration.reason = "The difference is too small to be sure of. Let it stand longer.";
    }
    return bias;
}

}  // namespace hedr
