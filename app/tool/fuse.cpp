#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "app/tool/command.h"
#include "app/tool/log_fusion.h"
#include "app/tool/lost_times.h"
#include "app/tool/track_table.h"
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
    std::string key;
    std::vector<std::string> settings;
};

Result<LogAndVehicle> inputOf(const Options& options) {
    return loadLogAndVehicle(options.input, options.vehicle, options.settings);
}

Result<NamedTrack> fuseLog(const Options& options, const Pose<World>& start) {
    const auto input = inputOf(options);
    if (!input) return tl::make_unexpected(input.error());
    const EstimatorEntry* entry = findEstimator(options.estimator);
    const auto enough =
        checkInputs(*entry, {options.input, input->log}, {options.vehicle, input->vehicle});
    if (!enough) return tl::make_unexpected(enough.error());
    auto tracks = trackedBy({entry}, *input, start, options.input);
    if (!tracks) return tl::make_unexpected(tracks.error());
    return std::move(tracks->front());
}

struct AllTracks {
    std::vector<NamedTrack> tracks;
    std::string remarks;
};

// A line for each estimator that has no track.
std::string reasonsOfTheOthers(const std::vector<NamedTrack>& tracks,
                               const EstimatorInputs& given) {
    std::string reasons;
    for (const EstimatorEntry& entry : estimatorTable()) {
        const bool heard = std::any_of(tracks.begin(), tracks.end(), [&](const NamedTrack& track) {
            return track.name == entry.name;
        });
        if (heard) continue;
        const auto missing = missingInput(entry.needs, given);
        reasons += std::string(entry.name) + " cannot run: ";
        reasons += !missing              ? "there are no reports of sensors"
                   : missing->in_vehicle ? "the vehicle file lacks " + std::string(missing->what)
                                         : "there is " + std::string(missing->what);
        reasons += '\n';
    }
    return reasons;
}

Result<AllTracks> allOfLog(const Options& options, const Pose<World>& start) {
    const auto input = inputOf(options);
    if (!input) return tl::make_unexpected(input.error());
    const EstimatorInputs given = inputsOf(input->log, input->vehicle);
    const auto able = estimatorsFor(given);
    if (able.empty()) {
        std::cout << reasonsOfTheOthers({}, given);
        return fail(ErrorCode::kNoData, options.input, "none of the estimators can run");
    }
    auto tracks = trackedBy(able, *input, start, options.input);
    if (!tracks) return tl::make_unexpected(tracks.error());
    std::string remarks = reasonsOfTheOthers(*tracks, given);
    return AllTracks{std::move(*tracks), std::move(remarks)};
}

Result<RecomputeOptions> recomputeOptions(const Options& options,
                                          std::optional<Pose<World>> start) {
    RecomputeOptions recompute{.start = start, .settings = options.settings};
    if (!options.vehicle.empty()) {
        const auto vehicle = loadVehicleOrPreset(options.vehicle);
        if (!vehicle) return tl::make_unexpected(vehicle.error());
        recompute.vehicle = *vehicle;
    }
    if (!options.key.empty()) {
        const auto key = loadKeyNamed(options.key);
        if (!key) return tl::make_unexpected(key.error());
        recompute.key = *key;
    }
    return recompute;
}

Result<AllTracks> allOfMission(const Options& options, std::optional<Pose<World>> start) {
    const auto recompute = recomputeOptions(options, start);
    if (!recompute) return tl::make_unexpected(recompute.error());
    auto again = recomputeTracks(options.input, *recompute);
    if (!again) return tl::make_unexpected(again.error());
    tellDamage(options.input, again->salvaged);
    AllTracks all;
    std::string changed;
    for (RecomputedTrack& track : again->tracks) {
        if (!track.as_live) changed += ' ' + track.name;
        all.tracks.push_back({track.name, std::move(track.points), std::move(track.lost)});
    }
    all.remarks = reasonsOfTheOthers(all.tracks, again->given);
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
    if (!saved) return saved;
    std::cout << *table << all->remarks;
    for (const NamedTrack& track : all->tracks) tellLostTimes(track.name, track.lost);
    return {};
}

Result<NamedTrack> fuseMission(const Options& options, std::optional<Pose<World>> start) {
    const auto recompute = recomputeOptions(options, start);
    if (!recompute) return tl::make_unexpected(recompute.error());
    auto track = recomputeTrack(options.input, options.estimator, *recompute);
    if (!track) return tl::make_unexpected(track.error());
    tellDamage(options.input, track->salvaged);
    std::cout << track->points.size() << " points, " << (track->as_live ? "bit for bit" : "not")
              << " the live track\n";
    return NamedTrack{track->name, std::move(track->points), std::move(track->lost)};
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

// It would change nothing, silently.
void refuseSettingsOfOthers(const Options& options) {
    if (options.estimator == kAll) return;
    for (const std::string& setting : options.settings) {
        for (const FusionKnob& knob : fusionKnobs()) {
            if (!setting.starts_with(std::string(knob.key) + '=')) continue;
            if (actsOn(knob, options.estimator)) continue;
            throw CLI::ValidationError("--set", std::string(knob.key) + " is for " +
                                                    std::string(knob.estimators) + ", not for " +
                                                    options.estimator);
        }
    }
}

std::string listOfKnobs() {
    std::string list;
    for (const FusionKnob& knob : fusionKnobs()) {
        list += "\n  " + std::string(knob.key) + " (" + std::string(knob.estimators) +
                "): " + std::string(knob.meaning) + " (default " + fusionValue({}, knob.key) + ')';
    }
    return list;
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
    tellLostTimes(track->name, track->lost);
    return saveTrack(options.out, track->points);
}

}  // namespace

Job addFuse(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    app.add_option("INPUT", options->input, "sensors.csv or a mission file")->required();
    app.add_option("--vehicle", options->vehicle,
                   vehicleHelp() + "; for a mission by default what was used live");
    auto names = estimatorNames();
    const std::string help = joined(names) + ", or all of them: " + kAll;
    names.push_back(kAll);
    app.add_option("--estimator", options->estimator, help)->required()->check(oneOf(names));
    app.add_option("--initial", options->initial, "X,Y,HEADING_DEG of the start")->check(aPose());
    app.add_option("--out", options->out,
                   "Track to write: CSV, or TUM if it ends in .tum; a folder for all of them")
        ->required()
        ->check(notEmpty());
    app.add_option("--truth", options->truth,
                   "With all of them: the true track, CSV or TUM; the table says how far they are")
        ->check(notEmpty());
    app.add_option("--key", options->key,
                   "A robot that has a key, or a file *.key: for a mission of a robot that signs, "
                   "recorded without its key")
        ->check(notEmpty());
    app.add_option("--set", options->settings,
                   "KEY=VALUE; defaults are those for a vehicle with a gyro" + listOfKnobs())
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
        if (!options->key.empty() && !looksLikeMission(options->input))
            throw CLI::ValidationError("--key", "is for a mission; a sensor log is not signed");
        refuseSettingsOfOthers(*options);
        refuseToOverwriteSources(*options);
    });
    return [options] { return runFuse(*options); };
}

}  // namespace hedr::tool
