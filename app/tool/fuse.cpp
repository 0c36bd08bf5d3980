#include <filesystem>
#include <iostream>
#include <memory>

#include "app/tool/command.h"
#include "core/fusion/tracker.h"
#include "core/robot/sensor_csv.h"
#include "core/track/track_file.h"
#include "radio/recomputation.h"

namespace hedr::tool {

namespace {

struct Options {
    std::string input;
    std::string vehicle;
    std::string estimator;
    std::string initial;
    std::string out;
    std::vector<std::string> settings;
};

Result<const EstimatorEntry*> estimatorFor(const std::string& name, const SensorLog& log,
                                           const std::string& file) {
    const EstimatorEntry* entry = findEstimator(name);
    const SensorReport& first = log.reports.front();
    if (entry->needs_gyro && std::holds_alternative<std::monostate>(first.gyro)) {
        return fail(ErrorCode::kMissingColumn, file, "gyro_z_rad_s, which " + name + " needs");
    }
    const bool wheels_apart = !std::holds_alternative<std::monostate>(first.odometry) &&
                              !std::holds_alternative<PathTravel>(first.odometry);
    if (entry->needs_both_wheels && !wheels_apart) {
        return fail(ErrorCode::kMissingColumn, file,
                    "left_ticks,right_ticks or left_m,right_m, which " + name + " needs");
    }
    return entry;
}

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
                  << " samples left out, nothing moves so fast\n";
    }
    if (motions.restarts() > 0) {
        std::cerr << "hedr: " << file << ": time or counters went back " << motions.restarts()
                  << " times; later times are moved on\n";
    }
}

Result<std::vector<TrackPoint>> fuseLog(const Options& options, const Pose<World>& start) {
    const auto log = loadSensorLog(options.input);
    if (!log) return tl::make_unexpected(log.error());
    warnOfIgnored(*log, options.input);
    const auto vehicle = loadVehicleOrPreset(options.vehicle);
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    const auto config = fusionConfig(*vehicle, options.settings);
    if (!config) return tl::make_unexpected(config.error());
    const auto entry = estimatorFor(options.estimator, *log, options.input);
    if (!entry) return tl::make_unexpected(entry.error());

    Tracker tracker({.vehicle = *vehicle,
                     .config = *config,
                     .start = start,
                     .clock_period_s = MotionBuilder::kNoWrap,
                     .estimators = {*entry}});
    std::vector<TrackPoint> track;
    track.reserve(log->reports.size());
    for (const SensorReport& report : log->reports) {
        if (tracker.add(report)) track.push_back(tracker.point(0));
    }
    warnOfBrokenSamples(tracker.motions(), options.input);
    return track;
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
    app.add_option("--estimator", options->estimator, estimatorNames())
        ->required()
        ->check(anEstimator());
    app.add_option("--initial", options->initial, "X,Y,HEADING_DEG of the start")->check(aPose());
    app.add_option("--out", options->out, "Track to write: CSV, or TUM if it ends in .tum")
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
        refuseToOverwriteSources(*options);
    });
    return [options] { return runFuse(*options); };
}

}  // namespace hedr::tool
