#include "core/calibration/gyro/gyro_bias_evidence.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kMostPoints = 300.0;

std::string degreesPerSecond(double rad_s, int digits = 2) {
    return shortNumber(degFromRad(rad_s), digits) + " °/s";
}

CalibrationProgress progressOf(const GyroBias& bias, double wanted_rad_s) {
    const double stood_s = bias.standing.duration_s();
    if (bias.needed_s == 0.0) return {.more = "It has to stand first"};
    CalibrationProgress progress{.share = std::clamp(stood_s / bias.needed_s, 0.0, 1.0)};
    if (bias.bias_rad_s.standard_error > 0.0) {
        progress.known = "Known to ±" + degreesPerSecond(bias.bias_rad_s.margin());
    }
    if (progress.share < 1.0) {
        const double noise = bias.noise_rad_s_sqrthz.value;
        const double then_rad_s = std::max(wanted_rad_s, noise / std::sqrt(bias.needed_s));
        progress.more = shortNumber(std::ceil(bias.needed_s - stood_s)) + " s more give ±" +
                        degreesPerSecond(Estimate{0.0, then_rad_s}.margin());
    }
    return progress;
}

std::vector<EvidenceFigure> figuresOf(const GyroBias& bias, const Stillness& stillness) {
    const Estimate& drift = bias.drift_rad_s2;
    const Estimate& noise = bias.noise_rad_s_sqrthz;
    std::vector<EvidenceFigure> figures{
        {"Time standing", bias.standing.duration_s(), "s"},
        {"Time needed", bias.needed_s, "s"},
        {"Noise", noise.value, "rad/s/sqrt(Hz)", noise.interval()},
        {"Drift while measuring", drift.value, "rad/s²", drift.interval()}};
    if (!stillness.unrest().empty())
        figures.push_back({"Unrest now (above 1: it moves)", stillness.unrest().back().strength});
    if (bias.temperature_c) figures.push_back({"Temperature", *bias.temperature_c, "°C"});
    return figures;
}

std::vector<std::string> remarksOn(const GyroBias& bias, const GyroSamples& gyro,
                                   const Stillness& stillness, std::size_t outliers) {
    std::vector<std::string> remarks;
    if (!bias.disturbances.empty()) {
        const Disturbance& last = bias.disturbances.back();
        const double after_s = last.sign.since_s - gyro.samples.front().t_s;
        remarks.push_back("After " + shortNumber(std::max(0.0, after_s)) +
                          " s the measurement stopped. " + sentenceOf(last.sign));
    }
    if (bias.left_out_s > 0.0) {
        remarks.push_back("The bias changed by " + degreesPerSecond(60.0 * bias.changed_rad_s2) +
                          " in a minute, so only the last " +
                          shortNumber(bias.standing.duration_s()) +
                          " s count. If the gyro is warming up, measure its warm-up.");
    }
    if (outliers > 0) {
        remarks.push_back(std::to_string(outliers) +
                          " readings far from the others were left out.");
    }
    if (gyro.broken > 0) {
        remarks.push_back(std::to_string(gyro.broken) +
                          " readings without a number or a time were left out.");
    }
    if (!stillness.hasWheels()) {
        remarks.emplace_back(
            "There are no encoders: a slow turn that lasted from the beginning would look like a "
            "bias.");
    }
    return remarks;
}

bool movedAt(const std::vector<Disturbance>& disturbances, double t_s) {
    return std::any_of(disturbances.begin(), disturbances.end(), [t_s](const Disturbance& each) {
        return each.sign.since_s <= t_s && t_s <= each.until_s;
    });
}

// Means over a second or more, so that the bias shows in the noise.
EvidencePlot ratePlot(const GyroBias& bias, const GyroSamples& gyro, double scale) {
    EvidencePlot plot{"Rate while standing", {"Time", "s"}, {"Rate", "rad/s"}};
    EvidenceSeries rate{"Rate", EvidenceSeries::Shape::kLine};
    EvidenceSeries moved{"Moved", EvidenceSeries::Shape::kDots};
    const double begin_s = gyro.samples.front().t_s - gyro.samples.front().dt_s;
    const double mean_over_s = std::max(1.0, gyro.duration_s() / kMostPoints);
    double turn_rad = 0.0;
    double span_s = 0.0;
    for (const GyroSample& sample : gyro.samples) {
        turn_rad += scale * sample.rate_rad_s * sample.dt_s;
        span_s += sample.dt_s;
        if (span_s < mean_over_s) continue;
        const double middle_s = sample.t_s - 0.5 * span_s;
        EvidenceSeries& series = movedAt(bias.disturbances, middle_s) ? moved : rate;
        series.x.push_back(middle_s - begin_s);
        series.y.push_back(turn_rad / span_s);
        turn_rad = span_s = 0.0;
    }
    plot.series = {std::move(rate), std::move(moved)};
    if (bias.bias_rad_s.standard_error > 0.0) {
        const Interval known = bias.bias_rad_s.interval();
        plot.series.push_back({"Bias",
                               EvidenceSeries::Shape::kBand,
                               {bias.standing.begin_s - begin_s, bias.standing.end_s - begin_s},
                               {known.low, known.low},
                               {known.high, known.high}});
    }
    return plot;
}

// The meter of stillness: how near to motion it is, and was.
EvidencePlot unrestPlot(const Stillness& stillness, double begin_s) {
    EvidencePlot plot{"Unrest (above 1: it moves)", {"Time", "s"}, {"Of the limit", ""}};
    EvidenceSeries unrest{"By the gyro", EvidenceSeries::Shape::kLine};
    for (const Unrest& each : stillness.unrest()) {
        unrest.x.push_back(each.t_s - begin_s);
        unrest.y.push_back(each.strength);
    }
    EvidenceSeries counted{"The encoders counted", EvidenceSeries::Shape::kDots};
    for (const Disturbance& each : stillness.disturbances()) {
        if (each.sign.kind != MotionSign::Kind::kCounted) continue;
        counted.x.push_back(each.sign.since_s - begin_s);
        counted.y.push_back(1.0);
    }
    if (unrest.x.empty()) return plot;
    EvidenceSeries limit{
        "Limit", EvidenceSeries::Shape::kDashes, {unrest.x.front(), unrest.x.back()}, {1.0, 1.0}};
    plot.series = {std::move(unrest), std::move(limit)};
    if (!counted.x.empty()) plot.series.push_back(std::move(counted));
    return plot;
}

}  // namespace

std::vector<CalibrationStep> gyroBiasSteps(const GyroBias& bias) {
    const bool moves = bias.state == Stillness::State::kMoves;
    const bool enough = bias.calibration.progress.share >= 1.0;
    return {{"Let it stand",
             moves ? sentenceOf(bias.disturbances.back().sign)
                   : "Put it on firm ground, motors off, and keep your hands off.",
             bias.state == Stillness::State::kStands || enough},
            {"Wait", "It must not move until the bias is known well enough.", enough}};
}

void addEvidence(GyroBias& bias, const GyroSamples& gyro, const Stillness& stillness,
                 std::size_t outliers, double gyro_scale, double wanted_standard_error_rad_s) {
    Calibration& calibration = bias.calibration;
    calibration.progress = progressOf(bias, wanted_standard_error_rad_s);
    calibration.steps = gyroBiasSteps(bias);
    calibration.figures = figuresOf(bias, stillness);
    calibration.remarks = remarksOn(bias, gyro, stillness, outliers);
    const double begin_s = gyro.samples.front().t_s - gyro.samples.front().dt_s;
    calibration.plots = {ratePlot(bias, gyro, gyro_scale), unrestPlot(stillness, begin_s)};
}

}  // namespace hedr
