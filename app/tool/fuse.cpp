#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>

#include "app/tool/command.h"
#include "core/fusion/tracker.h"
#include "core/robot/sensor_csv.h"
#include "core/track/track_file.h"
#include "radio/recomputation.h"

namespace hedr::tool {

namespace {

const std::string kAll = "all";

struct Options {
    std::string input;
    std::string vehicle;
    std::string estimator;
    std::string initial;
    std::string out;
    std::vector<std::string> settings;
};

void warnOfIgnored(const SensorLog& log, const std::string& file) {
    std::string names;
    for (const std::string& column : log.ignored_columns) {
        names += (names.empty() ? "" : ", ") + column;
    }
    if (!names.empty()) std::cerr << "hedr: " << file << ": not used: " << names << '\n';
}

void warnOfBrokenSamples(const MotionBuilder& motions, const std::string& file) {
    if (motions.brokenSamples() > 0) {
        std::cerr << "hedr: " << file << ": " << motions.brokenSamples()
                  << " samples left out: not a number, or too fast to be true\n";
    }
    if (motions.restarts() > 0) {
        std::cerr << "hedr: " << file << ": time or counters went back " << motions.restarts()
                  << " times; later times are moved on\n";
    }
}

// Says when the heading had nothing to hold on to.
class LostTimes {
  public:
    void note(const Tracker& tracker) {
        // One that runs along with a better one says nothing.
        const auto bayes = tracker.bayesStatus();
        const HedrStatus* hedr = tracker.hedrStatus();
        const bool lost = bayes ? bayes->lost : hedr && hedr->lost;
        if (lost == lost_) return;
        if (lost_) tell(tracker.motion().t_s);
        lost_ = lost;
        since_s_ = tracker.motion().t_s;
    }
    void finish(double t_s) const {
        if (lost_) tell(t_s);
    }

  private:
    void tell(double until_s) const {
        std::cerr << "hedr: LOST LOCK from " << since_s_ << " s to " << until_s
                  << " s: the direction of the corridors was not known\n";
    }

    bool lost_ = false;
    double since_s_ = 0.0;
};

struct LogAndVehicle {
    SensorLog log;
    Vehicle vehicle;
    FusionConfig config;
};

Result<LogAndVehicle> loadLogAndVehicle(const Options& options) {
    auto log = loadSensorLog(options.input);
    if (!log) return tl::make_unexpected(log.error());
    warnOfIgnored(*log, options.input);
    const auto vehicle = loadVehicleOrPreset(options.vehicle);
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    const auto config = fusionConfig(*vehicle, options.settings);
    if (!config) return tl::make_unexpected(config.error());
    return LogAndVehicle{std::move(*log), *vehicle, *config};
}

using Tracks = std::vector<std::vector<TrackPoint>>;

// One track per estimator.
Tracks trackedBy(const std::vector<const EstimatorEntry*>& estimators, const LogAndVehicle& input,
                 const Pose<World>& start, const std::string& file) {
    Tracker tracker({.vehicle = input.vehicle,
                     .config = input.config,
                     .start = start,
                     .clock_period_s = MotionBuilder::kNoWrap,
                     .estimators = estimators});
    Tracks tracks(estimators.size());
    LostTimes lost;
    for (auto& track : tracks) track.reserve(input.log.reports.size());
    for (const SensorReport& report : input.log.reports) {
        if (!tracker.add(report)) continue;
        for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].push_back(tracker.point(i));
        lost.note(tracker);
    }
    lost.finish(tracker.motion().t_s);
    warnOfBrokenSamples(tracker.motions(), file);
    return tracks;
}

Result<std::vector<TrackPoint>> fuseLog(const Options& options, const Pose<World>& start) {
    const auto input = loadLogAndVehicle(options);
    if (!input) return tl::make_unexpected(input.error());
    const EstimatorEntry* entry = findEstimator(options.estimator);
    const auto enough =
        checkInputs(*entry, {options.input, input->log}, {options.vehicle, input->vehicle});
    if (!enough) return tl::make_unexpected(enough.error());
    return std::move(trackedBy({entry}, *input, start, options.input).front());
}

void printRow(const EstimatorEntry& entry, const std::vector<TrackPoint>& track) {
    const auto& [position, heading_rad] = track.back().pose;
    std::cout << std::left << std::setw(18) << entry.name << std::right << std::setw(10)
              << position.x << std::setw(10) << position.y << std::setw(12)
              << degFromRad(heading_rad);
    const PoseVariance& variance = track.back().variance;
    if (variance.known()) {
        std::cout << std::setw(10) << std::sqrt(variance.var_x_m2 + variance.var_y_m2)
                  << std::setw(10)
                  << degFromRad(std::sqrt(static_cast<double>(variance.var_heading_rad2)));
    }
    std::cout << '\n';
}

// Every estimator's track into the folder --out, and one table of where they end.
Result<void> fuseAll(const Options& options, const Pose<World>& start) {
    const auto input = loadLogAndVehicle(options);
    if (!input) return tl::make_unexpected(input.error());
    std::error_code error;
    std::filesystem::create_directories(options.out, error);
    if (error) return fail(ErrorCode::kFileUnwritable, options.out, error.message());
    const EstimatorInputs given = inputsOf(input->log, input->vehicle);
    const std::vector<const EstimatorEntry*> able = estimatorsFor(given);
    const Tracks tracks = trackedBy(able, *input, start, options.input);
    std::cout << std::fixed << std::setprecision(2)
              << "estimator          end x_m       y_m heading_deg      +-m    +-deg\n";
    for (std::size_t i = 0; i < able.size(); ++i) {
        printRow(*able[i], tracks[i]);
        const auto file =
            std::filesystem::path(options.out) / (std::string(able[i]->name) + ".csv");
        auto saved = saveTrack(file, tracks[i]);
        if (!saved) return saved;
    }
    for (const EstimatorEntry& entry : estimatorTable()) {
        const auto missing = missingInput(entry.needs, given);
        if (missing) std::cout << entry.name << " needs " << missing->what << '\n';
    }
    return {};
}

Result<std::vector<TrackPoint>> fuseMission(const Options& options,
                                            std::optional<Pose<World>> start) {
    RecomputeOptions recompute{.start = start, .settings = options.settings};
    if (!options.vehicle.empty()) {
        const auto vehicle = loadVehicleOrPreset(options.vehicle);
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        recompute.vehicle = *vehicle;
    }
    auto track = recomputeTrack(options.input, options.estimator, recompute);
    if (!track) return tl::make_unexpected(track.error());
    std::cout << track->points.size() << " points, " << (track->as_live ? "bit for bit" : "not")
              << " the live track\n";
    return std::move(track->points);
}

// A recording cannot be made again.
void refuseToOverwriteSources(const Options& options) {
    std::error_code ignored;
    const bool same = std::filesystem::equivalent(options.out, options.input, ignored) ||
                      std::filesystem::equivalent(options.out, options.vehicle, ignored);
    if (same || looksLikeMission(options.out)) {
        throw CLI::ValidationError("--out", options.out + " would be overwritten");
    }
}

Result<void> runFuse(const Options& options) {
    std::optional<Pose<World>> start;
    if (!options.initial.empty()) {
        const auto pose = parsePose(options.initial);
        if (!pose) return tl::make_unexpected(pose.error());
        start = *pose;
    }
    if (options.estimator == kAll) return fuseAll(options, start.value_or(Pose<World>{}));
    const auto track = looksLikeMission(options.input)
                           ? fuseMission(options, start)
                           : fuseLog(options, start.value_or(Pose<World>{}));
    if (!track) return tl::make_unexpected(track.error());
    return saveTrack(options.out, *track);
}

}  // namespace

Job addFuse(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("INPUT", options->input, "sensors.csv or a mission file")->required();
    app.add_option("--vehicle", options->vehicle,
                   "vehicle.toml or preset; for a mission by default what was used live");
    app.add_option("--estimator", options->estimator,
                   estimatorNames() + ", or all of them: " + kAll)
        ->required()
        ->check(anEstimator() | CLI::IsMember({kAll}));
    app.add_option("--initial", options->initial, "X,Y,HEADING_DEG of the start")->check(aPose());
    app.add_option("--out", options->out,
                   "Track to write: CSV, or TUM if it ends in .tum; a folder for all of them")
        ->required()
        ->check(notEmpty());
    std::string keys;
    for (const FusionKnob& knob : fusionKnobs()) {
        keys += "\n  " + std::string(knob.key) + ": " + std::string(knob.meaning);
    }
    app.add_option("--set", options->settings, "KEY=VALUE, one of" + keys)
        ->allow_extra_args(false)
        ->check(aSetting([](const std::string& key, const std::string& value) {
            FusionConfig config;
            return setFusionValue(config, key, value);
        }));
    app.callback([options] {
        needVehicleForLog(options->input, options->vehicle);
        if (options->estimator == kAll && looksLikeMission(options->input))
            throw CLI::ValidationError("--estimator", "all works on a sensors.csv");
        refuseToOverwriteSources(*options);
    });
    return [options] { return runFuse(*options); };
}

}  // namespace hedr::tool
