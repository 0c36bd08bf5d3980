#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/stop_signals.h"
#include "app/tool/command.h"
#include "app/tool/comparison.h"
#include "app/tool/json_line.h"
#include "app/tool/log_fusion.h"
#include "app/tool/progress_line.h"
#include "core/fusion/tuning.h"
#include "core/track/track_file.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string input;
    std::string truth;
    std::string vehicle;
    std::string estimator;
    bool json = false;
};

constexpr std::array kTunable{"gh_gyro", "gh_magnetometer", "gh_combined"};
const std::string kCombined = kTunable.back();

struct GainName {
    double GhGains::*gain;
    const char* name;
    const char* knob;
};
constexpr std::array kGainNames{GainName{&GhGains::alpha, "alpha", "gh_alpha"},
                                GainName{&GhGains::beta, "beta", "gh_beta"},
                                GainName{&GhGains::gamma, "gamma", "gh_gamma"}};

std::span<const GainName> gainsOf(const std::string& estimator) {
    return std::span(kGainNames).first(estimator == kCombined ? 3 : 2);
}

const GainName& nameOf(double GhGains::*gain) {
    return *std::find_if(kGainNames.begin(), kGainNames.end(),
                         [gain](const GainName& each) { return each.gain == gain; });
}

// A drive with its truth, ready to be tried with many gains.
struct Drive {
    std::vector<Motion> motions;
    std::vector<TrackPoint> truth;
    FusionConfig config;

    // Mean absolute error of the position, the track put on the truth at its start: Eq. (9).
    Result<double> error_m(const EstimatorEntry& entry, const FusionConfig& tried) const {
        AnyEstimator estimator = entry.make({}, tried);
        std::vector<TrackPoint> track;
        track.reserve(motions.size());
        for (const Motion& motion : motions) {
            std::visit(
                [&](auto& known) {
                    known.update(motion);
                    track.push_back({.t_s = motion.t_s, .pose = known.pose()});
                },
                estimator);
        }
        return compare(track, truth, Alignment::kStart, "The track or the truth")
            .map([](const Evaluation& evaluation) { return evaluation.ape_mean_m; });
    }
    Result<double> error_m(const EstimatorEntry& entry, const GhGains& gains) const {
        FusionConfig tried = config;
        tried.gh.alpha = gains.alpha;
        tried.gh.beta = gains.beta;
        tried.gh.gamma = gains.gamma;
        return error_m(entry, tried);
    }
};

struct Outcome {
    Tuning tuning;
    std::optional<double> odometry_error_m;  // where the wheels are told apart
};

Result<Drive> loadDrive(const Options& options) {
    const auto input = loadLogAndVehicle(options.input, options.vehicle, {});
    if (!input) return tl::make_unexpected(input.error());
    const auto enough = checkInputs(*findEstimator(options.estimator), {options.input, input->log},
                                    {options.vehicle, input->vehicle});
    if (!enough) return tl::make_unexpected(enough.error());
    auto truth = loadTrack(options.truth);
    if (!truth) return tl::make_unexpected(truth.error());
    auto motions = motionsOf(*input, options.input);
    if (!motions) return tl::make_unexpected(motions.error());
    return Drive{
        .motions = std::move(*motions), .truth = std::move(*truth), .config = input->config};
}

Result<Outcome> tuned(const Options& options, const Drive& drive) {
    const EstimatorEntry& entry = *findEstimator(options.estimator);
    const GhConfig& preset = drive.config.gh;
    const GhGains start{preset.alpha, preset.beta, preset.gamma};
    const auto judged = drive.error_m(entry, start);
    if (!judged) return tl::make_unexpected(judged.error());
    std::vector<double GhGains::*> gains;
    for (const GainName& each : gainsOf(options.estimator)) gains.push_back(each.gain);
    ProgressLine progress("trial");
    auto tuning = tuneGains(
        start, gains,
        [&](const GhGains& tried) {
            return drive.error_m(entry, tried).value_or(std::numeric_limits<double>::infinity());
        },
        [&](std::size_t made, std::size_t of) {
            progress.show(made + 1, of);
            return !stopSignalled();
        });
    if (!tuning) return fail(ErrorCode::kCanceled, "the tuning");
    Outcome outcome{.tuning = std::move(*tuning), .odometry_error_m = {}};
    const bool both_wheels =
        std::any_of(drive.motions.begin(), drive.motions.end(),
                    [](const Motion& motion) { return motion.odometry_turn_rad.has_value(); });
    if (both_wheels) {
        const auto odometry = drive.error_m(*findEstimator("odometry"), drive.config);
        if (odometry) outcome.odometry_error_m = *odometry;
    }
    return outcome;
}

// More than 1 % between the best and the worst value of any sweep.
bool matters(const Tuning& tuning, double GhGains::*gain) {
    constexpr double kNoticed = 1.01;
    return std::any_of(tuning.sweeps.begin(), tuning.sweeps.end(), [&](const TuningSweep& sweep) {
        const auto [best, worst] =
            std::minmax_element(sweep.trials.begin(), sweep.trials.end(),
                                [](const auto& a, const auto& b) { return a.error < b.error; });
        return sweep.gain == gain && worst->error > best->error * kNoticed;
    });
}

void printSweeps(const Tuning& tuning) {
    std::cout << std::fixed << "gain    value  mean absolute error in m  (*: the best)\n";
    for (const TuningSweep& sweep : tuning.sweeps) {
        for (const auto& trial : sweep.trials) {
            const bool best = trial.value == sweep.chosen && matters(tuning, sweep.gain);
            std::cout << std::left << std::setw(6) << nameOf(sweep.gain).name << std::right
                      << std::setprecision(2) << std::setw(7) << trial.value << std::setprecision(4)
                      << std::setw(26) << trial.error << (best ? " *\n" : "\n");
        }
    }
}

void printBest(const Tuning& tuning, const Options& options) {
    std::string best;
    for (const GainName& each : gainsOf(options.estimator)) {
        if (!matters(tuning, each.gain)) {
            std::cout << each.name << " makes no difference: within 1 %\n";
            continue;
        }
        std::ostringstream value;
        value << std::fixed << std::setprecision(2) << tuning.best.*each.gain;
        best += std::string(" --set ") + each.knob + '=' + value.str();
    }
    std::cout << (best.empty() ? "any gains:" : "best:" + best + " ") << ' ' << std::setprecision(4)
              << tuning.error << " m\n";
}

void printText(const Outcome& outcome, const Options& options) {
    printSweeps(outcome.tuning);
    printBest(outcome.tuning, options);
    if (outcome.tuning.best.alpha == 0.0 && matters(outcome.tuning, &GhGains::alpha))
        std::cout << "alpha 0: the sensed heading is best left out\n";
    if (!outcome.odometry_error_m) return;
    std::cout << "odometry alone: " << *outcome.odometry_error_m << " m; the fusion is "
              << (outcome.tuning.error < *outcome.odometry_error_m ? "better" : "no better")
              << " on this drive\n";
}

void printJson(const Outcome& outcome, const Options& options) {
    nlohmann::ordered_json object;
    object["estimator"] = options.estimator;
    for (const GainName& each : gainsOf(options.estimator)) {
        object[each.knob] = outcome.tuning.best.*each.gain;
    }
    object["error_m"] = outcome.tuning.error;
    if (outcome.odometry_error_m) object["odometry_error_m"] = *outcome.odometry_error_m;
    for (const TuningSweep& sweep : outcome.tuning.sweeps) {
        for (const auto& trial : sweep.trials) {
            object["trials"].push_back({{"gain", nameOf(sweep.gain).knob},
                                        {"value", trial.value},
                                        {"error_m", trial.error}});
        }
    }
    std::cout << jsonLine(object);
}

Result<void> runTune(const Options& options) {
    holdStopSignals();
    const auto drive = loadDrive(options);
    if (!drive) return tl::make_unexpected(drive.error());
    const auto outcome = tuned(options, *drive);
    if (!outcome) return tl::make_unexpected(outcome.error());
    if (options.json) {
        printJson(*outcome, options);
    } else {
        printText(*outcome, options);
    }
    return {};
}

}  // namespace

Job addTune(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("SENSORS", options->input, "sensors.csv")->required();
    app.add_option("--truth", options->truth, "The true track, CSV or TUM")->required();
    app.add_option("--vehicle", options->vehicle, vehicleHelp())->required();
    app.add_option("--estimator", options->estimator, "gh_gyro, gh_magnetometer or gh_combined")
        ->required()
        ->check(oneOf({kTunable.begin(), kTunable.end()}));
    app.add_flag("--json", options->json, "One JSON object on standard output");
    return [options] { return runTune(*options); };
}

}  // namespace hedr::tool
