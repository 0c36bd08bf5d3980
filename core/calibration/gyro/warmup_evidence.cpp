#include "core/calibration/gyro/warmup_evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/calibration/short_number.h"

namespace hedr {

namespace {

constexpr double kPlottedBeyond = 1.25;  // times what was seen
constexpr int kCurvePoints = 80;

std::string perMinute(double rad_s) {
    constexpr double kLeast_deg = 0.01;
    return shortNumber(std::max(kLeast_deg, degFromRad(60.0 * rad_s))) + " °/min";
}

std::vector<CalibrationStep> warmupSteps(const Warmup& warmup) {
    return {{"Start cold",
             "Switch the gyro on after it was off for long, and let the robot stand at once.",
             warmup.stood_s > 0.0},
            {"Let it stand",
             warmup.motion ? sentenceOf(*warmup.motion)
                           : "Put it on firm ground, motors off, and keep your hands off.",
             warmup.known}};
}

CalibrationProgress warmupProgress(const Warmup& warmup) {
    if (!warmup.warms_up) return {.more = "Nothing can be told of its warming up yet"};
    if (!warmup.cost) return {.more = "It warms up; the curve must bend first"};
    const WarmupFit& fit = *warmup.fit;
    const Estimate relative{0.0, fit.relativeErrorOfTime(), fit.degrees_of_freedom};
    const double wanted = kKnownTimeError / relative.standard_error;
    CalibrationProgress progress{
        .share = std::min(1.0, wanted * wanted),
        .known = "Time to warm up known to ±" + percentText(relative.margin())};
    if (!warmup.known && warmup.known_in_s) {
        progress.more = spokenTime(*warmup.known_in_s) + " more give ±" +
                        percentText(wanted * relative.margin());
    }
    return progress;
}

std::vector<EvidenceFigure> warmupFigures(const Warmup& warmup) {
    std::vector<EvidenceFigure> figures{{"Time standing", warmup.stood_s, "s"}};
    if (!warmup.fit) return figures;
    const WarmupFit& fit = *warmup.fit;
    figures.push_back({"Chance that white noise looks like the rest", warmup.whiteness.p_value});
    if (!warmup.cost) return figures;
    const double now_rad_s = biasAt(fit.curve, warmup.on_s);
    const double left_rad_s = fit.curve.c1_rad_s + fit.curve.c2_rad_s - now_rad_s;
    std::vector<EvidenceFigure> told{
        {"Time constant", fit.curve.time_s, "s", fit.time_s().interval()}};
    if (warmup.follows) {
        told.push_back({"Drift that is left", left_rad_s, "rad/s"});
        if (*warmup.settled_in_s > 0.0)
            told.push_back({"Until it is warm", *warmup.settled_in_s, "s"});
        told.push_back({"Drive now, bias held, at most", warmup.cost->held_rad_s, "rad/s"});
        told.push_back({"Drive now, with the curve, at most", warmup.cost->curve_rad_s, "rad/s"});
    }
    figures.insert(figures.begin() + 1, told.begin(), told.end());
    if (fit.room == RoomTemperature::kMayChange) {
        const Interval drift = fit.room_rad_s2().interval();
        figures.push_back({"Drift by the room", fit.room_drift_rad_s2, "rad/s²", drift});
    }
    figures.push_back({"Steps of the fit", static_cast<double>(fit.iterations)});
    return figures;
}

void addForecast(std::vector<std::string>& remarks, const Warmup& warmup, double matters_rad_s) {
    remarks.push_back("Start now with the bias as it is: at most " +
                      perMinute(warmup.cost->held_rad_s) +
                      " in the next 10 min. With the curve: at most " +
                      perMinute(warmup.cost->curve_rad_s) + ".");
    const std::string left = "less than " + perMinute(matters_rad_s) + " of the gyro's own drift";
    remarks.push_back(*warmup.settled_in_s > 0.0
                          ? "In " + spokenTime(*warmup.settled_in_s) + ' ' + left + " is left."
                          : "Now " + left + " is left.");
}

// What it would do to the curve if the room, told to be steady, had changed just enough to matter.
std::string remarkOnTheRoom(const WarmupFit& fit, std::span<const WarmupBlock> blocks,
                            double matters_rad_s) {
    const double span_s = blocks.back().end_s - blocks.front().begin_s;
    std::vector<WarmupBlock> bent(blocks.begin(), blocks.end());
    for (WarmupBlock& block : bent)
        block.mean_rad_s += matters_rad_s * (block.middle_s() - blocks.front().begin_s) / span_s;
    const GyroDrift curve = refitWarmup(bent, fit).curve;
    return "The room's temperature is taken for steady. Had it made the bias drift by " +
           perMinute(matters_rad_s) + " meanwhile, the change while warming up would be wrong by " +
           percentText(std::abs(curve.c1_rad_s / fit.curve.c1_rad_s - 1.0)) + ", the time by " +
           percentText(std::abs(curve.time_s / fit.curve.time_s - 1.0)) +
           ". If it may change, say so.";
}

std::vector<std::string> warmupRemarks(const Warmup& warmup, std::span<const WarmupBlock> blocks,
                                       double matters_rad_s) {
    std::vector<std::string> remarks;
    if (warmup.motion) {
        remarks.push_back("After " + spokenTime(warmup.motion->since_s) +
                          " the measurement stopped. " + sentenceOf(*warmup.motion));
    }
    if (warmup.cost && warmup.follows) addForecast(remarks, warmup, matters_rad_s);
    if (warmup.known && warmup.fit->room == RoomTemperature::kSteady)
        remarks.push_back(remarkOnTheRoom(*warmup.fit, blocks, matters_rad_s));
    if (warmup.known) {
        remarks.emplace_back(
            "Next time it warms up much the same way, not quite: it starts from another "
            "temperature.");
    }
    return remarks;
}

EvidencePlot curvePlot(const Warmup& warmup, std::span<const WarmupBlock> blocks) {
    using Drawn = EvidenceSeries::Shape;
    EvidenceSeries band{"95 %", Drawn::kBand};
    EvidenceSeries curve{"Curve", Drawn::kLine};
    EvidenceSeries means{"Rate", Drawn::kDots};
    for (const WarmupBlock& block : blocks) {
        means.x.push_back(block.middle_s());
        means.y.push_back(block.mean_rad_s);
    }
    EvidencePlot plot{"Rate since it was switched on", {"Time", "s"}, {"Rate", "rad/s"}};
    plot.series = {std::move(means)};
    if (!warmup.cost) return plot;
    const double begin_s = blocks.front().begin_s;
    const double span_s = kPlottedBeyond * (blocks.back().end_s - begin_s);
    for (int i = 0; i <= kCurvePoints; ++i) {
        const double t_s = begin_s + span_s * i / kCurvePoints;
        const Estimate bias = warmup.fit->bias_rad_s(t_s);
        const Interval known = bias.interval();
        band.x.push_back(t_s);
        band.y.push_back(known.low);
        band.y_high.push_back(known.high);
        curve.x.push_back(t_s);
        curve.y.push_back(bias.value);
    }
    plot.series.insert(plot.series.begin(), std::move(band));
    plot.series.push_back(std::move(curve));
    return plot;
}

}  // namespace

void addWarmupEvidence(Warmup& warmup, std::span<const WarmupBlock> blocks,
                       const WarmupOptions& options) {
    Calibration& calibration = warmup.calibration;
    calibration.steps = warmupSteps(warmup);
    calibration.progress = warmupProgress(warmup);
    calibration.figures = warmupFigures(warmup);
    calibration.remarks = warmupRemarks(warmup, blocks, options.matters_rad_s);
    calibration.plots = {curvePlot(warmup, blocks)};
    if (warmup.fit) {
        const double spacing_s = blocks.front().span_s();
        calibration.plots.push_back(autocorrelationPlot(warmup.whiteness, spacing_s));
    }
}

std::string spokenTime(double time_s) {
    constexpr double kInMinutes_s = 120.0;
    return time_s < kInMinutes_s ? shortNumber(std::round(time_s)) + " s"
                                 : shortNumber(std::round(time_s / 60.0)) + " min";
}

}  // namespace hedr
