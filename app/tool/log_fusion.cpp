#include "app/tool/log_fusion.h"

#include <cstddef>
#include <iostream>

#include "app/tool/command.h"
#include "app/tool/progress_line.h"
#include "core/fusion/tracker.h"

namespace hedr::tool {

namespace {

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

// Of one of the tracker's estimators; false for those that cannot say it.
bool saysLost(const Tracker& tracker, const std::string& estimator) {
    if (estimator == "hedr_bayes") return tracker.bayesStatus()->lost;
    return estimator == "hedr" && tracker.hedrStatus()->lost;
}

void follow(const std::vector<SensorReport>& reports, Tracker& tracker,
            std::vector<NamedTrack>& tracks) {
    ProgressLine progress("fusing");
    std::size_t heard = 0;
    for (const SensorReport& report : reports) {
        progress.show(heard++, reports.size());
        if (!tracker.add(report)) continue;
        for (std::size_t i = 0; i < tracks.size(); ++i) {
            tracks[i].points.push_back(tracker.point(i));
            tracks[i].lost.note(saysLost(tracker, tracks[i].name), tracker.motion().t_s);
        }
    }
}

}  // namespace

Result<LogAndVehicle> loadLogAndVehicle(const std::string& log_file,
                                        const std::string& vehicle_file,
                                        const std::vector<std::string>& settings) {
    auto log = loadSensorLog(log_file);
    if (!log) return tl::make_unexpected(log.error());
    warnOfIgnored(*log, log_file);
    const auto vehicle = loadVehicleOrPreset(vehicle_file);
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    const auto config = fusionConfig(*vehicle, settings);
    if (!config) return tl::make_unexpected(config.error());
    return LogAndVehicle{std::move(*log), *vehicle, *config};
}

std::vector<NamedTrack> trackedBy(const std::vector<const EstimatorEntry*>& estimators,
                                  const LogAndVehicle& input, const Pose<World>& start,
                                  const std::string& file) {
    Tracker tracker({.vehicle = input.vehicle,
                     .config = input.config,
                     .start = start,
                     .clock_period_s = MotionBuilder::kNoWrap,
                     .estimators = estimators});
    std::vector<NamedTrack> tracks;
    for (const EstimatorEntry* entry : estimators) {
        tracks.push_back({std::string(entry->name), {}});
        tracks.back().points.reserve(input.log.reports.size());
    }
    follow(input.log.reports, tracker, tracks);
    warnOfBrokenSamples(tracker.motions(), file);
    return tracks;
}

}  // namespace hedr::tool
