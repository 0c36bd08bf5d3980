#include "app/tool/log_fusion.h"

#include <algorithm>
#include <cstddef>
#include <iostream>

#include "app/tool/command.h"
#include "app/tool/progress_line.h"
#include "core/fusion/tracker.h"

namespace hedr::tool {

namespace {

void warnOfBrokenSamples(const MotionBuilder& motions, const std::string& file) {
    if (motions.brokenSamples() > 0) {
        std::cerr << "hedr: " << file << ": " << motions.brokenSamples()
                  << " samples left out: not a number, or too fast to be true\n";
    }
    if (motions.restarts() > 0) {
        std::cerr << "hedr: " << file << ": time or counters went back or jumped "
                  << motions.restarts() << " times; counting goes on afresh from there\n";
    }
}

std::string whyNoMotion(const SensorLog& log, const MotionBuilder& motions) {
    const std::string samples = std::to_string(log.reports.size());
    const std::string broken = std::to_string(motions.brokenSamples());
    if (log.reports.size() == 1) return "it has one sample, and a way needs two";
    // A log's numbers are finite, so that only its times can be to blame.
    if (motions.brokenSamples() == log.reports.size())
        return "all of its " + samples +
               " samples were left out, their times are too large: t_s is in seconds, and these "
               "may be milliseconds since 1970";
    if (motions.brokenSamples() > 0)
        return "no two of its " + samples + " samples go together; left out: " + broken +
               ", too fast to be true or a day apart, so that the times or the odometry may be in "
               "other units";
    return "the times of its " + samples + " samples never go forward";
}

Result<void> judgeSamples(const SensorLog& log, const MotionBuilder& motions, bool any_motion,
                          const std::string& file) {
    if (!any_motion) return fail(ErrorCode::kNoData, file, whyNoMotion(log, motions));
    warnOfBrokenSamples(motions, file);
    return {};
}

// Of one of the tracker's estimators; false for those that cannot say it.
bool saysLost(const Tracker& tracker, const std::string& estimator) {
    if (estimator == "hedr_bayes") return tracker.bayesStatus()->lost;
    return estimator == "hedr" && tracker.hedrStatus()->lost;
}

// True if anything moved on from the start.
bool follow(const std::vector<SensorReport>& reports, Tracker& tracker,
            std::vector<NamedTrack>& tracks) {
    bool any_motion = false;
    ProgressLine progress("fusing");
    std::size_t heard = 0;
    for (const SensorReport& report : reports) {
        progress.show(heard++, reports.size());
        if (!tracker.add(report)) continue;
        any_motion = any_motion || tracker.motion().dt_s > 0.0;
        for (std::size_t i = 0; i < tracks.size(); ++i) {
            tracks[i].points.push_back(tracker.point(i));
            tracks[i].lost.note(saysLost(tracker, tracks[i].name), tracker.motion().t_s);
        }
    }
    return any_motion;
}

}  // namespace

// A damaged header may have thousands of columns, and each of any length.
void warnOfIgnored(const SensorLog& log, const std::string& file) {
    constexpr std::size_t kMostNames = 8;
    constexpr std::size_t kLongestName = 40;
    const std::vector<std::string>& columns = log.ignored_columns;
    if (columns.empty()) return;
    std::string names;
    for (std::size_t i = 0; i < std::min(columns.size(), kMostNames); ++i) {
        names += (names.empty() ? "" : ", ") + columns[i].substr(0, kLongestName);
        if (columns[i].size() > kLongestName) names += "...";
    }
    std::cerr << "hedr: " << file << ": not used: " << names;
    if (columns.size() > kMostNames) std::cerr << " and " << columns.size() - kMostNames << " more";
    std::cerr << '\n';
}

Result<LogAndVehicle> loadLogAndVehicle(const std::string& log_file,
                                        const std::string& vehicle_file,
                                        const std::vector<std::string>& settings) {
    auto log = loadSensorLog(log_file);
    if (!log) return tl::make_unexpected(log.error());
    warnOfIgnored(*log, log_file);
    auto vehicle = loadVehicleOrPreset(vehicle_file);
    if (!vehicle) return tl::make_unexpected(vehicle.error());
    // Where there is no gyro the turn is the encoders', whatever the file takes for granted.
    if (!inputsOf(*log, *vehicle).gyro) vehicle->heading_source = HeadingSource::kEncoders;
    const auto config = fusionConfig(*vehicle, settings);
    if (!config) return tl::make_unexpected(config.error());
    return LogAndVehicle{std::move(*log), *vehicle, *config};
}

Result<std::vector<NamedTrack>> trackedBy(const std::vector<const EstimatorEntry*>& estimators,
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
    const bool any_motion = follow(input.log.reports, tracker, tracks);
    const auto usable = judgeSamples(input.log, tracker.motions(), any_motion, file);
    if (!usable) return tl::make_unexpected(usable.error());
    return tracks;
}

Result<std::vector<Motion>> motionsOf(const LogAndVehicle& input, const std::string& file) {
    std::vector<Motion> motions;
    MotionBuilder builder(input.vehicle);
    for (const SensorReport& report : input.log.reports) {
        if (const auto motion = builder.add(report)) motions.push_back(*motion);
    }
    const auto usable = judgeSamples(input.log, builder, !motions.empty(), file);
    if (!usable) return tl::make_unexpected(usable.error());
    return motions;
}

}  // namespace hedr::tool
