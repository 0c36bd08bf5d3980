#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "app/tool/command.h"
#include "app/tool/lost_times.h"
#include "app/tool/track_table.h"
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
    std::string truth;
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

struct AllTracks {
    std::vector<NamedTrack> tracks;
    std::string remarks;
};

Result<AllTracks> allOfLog(const Options& options, const Pose<World>& start) {
    const auto input = loadLogAndVehicle(options);
    if (!input) return tl::make_unexpected(input.error());
    const EstimatorInputs given = inputsOf(input->log, input->vehicle);
    const std::vector<const EstimatorEntry*> able = estimatorsFor(given);
    Tracks tracks = trackedBy(able, *input, start, options.input);
    AllTracks all;
    for (std::size_t i = 0; i < able.size(); ++i) {
        all.tracks.push_back({std::string(able[i]->name), std::move(tracks[i])});
    }
    for (const EstimatorEntry& entry : estimatorTable()) {
        const auto missing = missingInput(entry.needs, given);
        if (missing) {
            all.remarks += std::string(entry.name) + " needs " + std::string(missing->what) + '\n';
        }
    }
    return all;
}

Result<RecomputeOptions> recomputeOptions(const Options& options,
                                          std::optional<Pose<World>> start) {
    RecomputeOptions recompute{.start = start, .settings = options.settings};
    if (!options.vehicle.empty()) {
        const auto vehicle = loadVehicleOrPreset(options.vehicle);
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        recompute.vehicle = *vehicle;
    }
    return recompute;
}

Result<AllTracks> allOfMission(const Options& options, std::optional<Pose<World>> start) {
    const auto recompute = recomputeOptions(options, start);
    if (!recompute) return tl::make_unexpected(recompute.error());
    auto tracks = recomputeTracks(options.input, *recompute);
    if (!tracks) return tl::make_unexpected(tracks.error());
    AllTracks all;
    std::string changed;
    for (RecomputedTrack& track : *tracks) {
        if (!track.as_live) changed += ' ' + track.name;
        all.tracks.push_back({track.name, std::move(track.points)});
    }
    std::string silent;
    for (const EstimatorEntry& entry : estimatorTable()) {
        const bool heard =
            std::any_of(all.tracks.begin(), all.tracks.end(),
                        [&](const NamedTrack& track) { return track.name == entry.name; });
        if (!heard) silent += ' ' + std::string(entry.name);
    }
    if (!silent.empty()) {
        all.remarks = "not possible with this robot and vehicle file:" + silent + '\n';
    }
    all.remarks +=
        changed.empty() ? "bit for bit the live tracks\n" : "not the live track:" + changed + '\n';
    return all;
}

// Every estimator's track into the folder --out, and one table of them.
Result<void> fuseAll(const Options& options, std::optional<Pose<World>> start) {
    Truth truth;
    if (!options.truth.empty()) {
        auto loaded = loadTrack(options.truth);
        if (!loaded) return tl::make_unexpected(loaded.error());
        truth = std::move(*loaded);
    }
    const auto all = looksLikeMission(options.input)
                         ? allOfMission(options, start)
                         : allOfLog(options, start.value_or(Pose<World>{}));
    if (!all) return tl::make_unexpected(all.error());
    const auto table = trackTable(all->tracks, truth);
    if (!table) return tl::make_unexpected(table.error());
    auto saved = saveTracks(options.out, all->tracks);
    if (saved) std::cout << *table << all->remarks;
    return saved;
}

Result<std::vector<TrackPoint>> fuseMission(const Options& options,
                                            std::optional<Pose<World>> start) {
    const auto recompute = recomputeOptions(options, start);
    if (!recompute) return tl::make_unexpected(recompute.error());
    auto track = recomputeTrack(options.input, options.estimator, *recompute);
    if (!track) return tl::make_unexpected(track.error());
    std::cout << track->points.size() << " points, " << (track->as_live ? "bit for bit" : "not")
              << " the live track\n";
    return std::move(track->points);
}

// A recording cannot be made again.
void refuseToOverwriteSources(const Options& options) {
    std::vector<std::filesystem::path> written{options.out};
    if (options.estimator == kAll) {
        for (const EstimatorEntry& entry : estimatorTable()) {
            written.push_back(written.front() / (std::string(entry.name) + ".csv"));
        }
        written.push_back(written.front() / (std::string(kRobotTrack) + ".csv"));
    }
    std::error_code ignored;
    for (const auto& file : written) {
        bool source = looksLikeMission(file.string());
        for (const std::string& read : {options.input, options.vehicle, options.truth}) {
            source = source || std::filesystem::equivalent(file, read, ignored);
        }
        if (source) throw CLI::ValidationError("--out", file.string() + " would be overwritten");
    }
}

Result<void> runFuse(const Options& options) {
    std::optional<Pose<World>> start;
    if (!options.initial.empty()) {
        const auto pose = parsePose(options.initial);
        if (!pose) return tl::make_unexpected(pose.error());
        start = *pose;
    }
    if (options.estimator == kAll) return fuseAll(options, start);
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
    app.add_option("--truth", options->truth,
                   "With all of them: the true track, CSV or TUM; the table says how far they are")
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
        if (!options->truth.empty() && options->estimator != kAll)
            throw CLI::ValidationError(
                "--truth", "goes with --estimator all; one track is judged by hedr evaluate");
        refuseToOverwriteSources(*options);
    });
    return [options] { return runFuse(*options); };
}

}  // namespace hedr::tool
