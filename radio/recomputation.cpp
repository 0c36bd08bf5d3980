#include "radio/recomputation.h"

#include <algorithm>
#include <utility>

#include "core/fusion/estimators.h"
#include "core/mission/mission_reader.h"

namespace hedr {

namespace {

// A mission does not store the variances.
bool samePoses(const std::vector<TrackPoint>& a, const std::vector<TrackPoint>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
        return p.t_s == q.t_s && p.pose == q.pose && p.gyro_bias_rad_s == q.gyro_bias_rad_s;
    });
}

// What keeps an estimator from working that is no matter of the mission's reports.
std::optional<Error> keyMissingFor(const EstimatorEntry& entry,
                                   const std::optional<Vehicle>& vehicle) {
    if (!vehicle) return std::nullopt;
    EstimatorInputs given = inputsOf(*vehicle);
    given.gyro = given.both_wheels = given.magnetometer = true;
    const auto missing = missingInput(entry.needs, given);
    if (!missing) return std::nullopt;
    return Error{ErrorCode::kMissingKey, "the vehicle " + vehicle->name,
                 std::string(missing->what) + ", which " + std::string(entry.name) + " needs"};
}

}  // namespace

Result<void> feedMission(const MissionReader& mission, Receiver& receiver,
                         const std::function<void()>& after_each_row) {
    return mission.forEachStreamRow([&](const StreamRow& row) {
        if (row.kind == StreamKind::kBytes) receiver.feed(row.data);
        if (row.kind == StreamKind::kPortOpened) receiver.portOpened();
        if (after_each_row) after_each_row();
        return true;
    });
}

namespace {

struct Heard {
    std::vector<RecomputedTrack> tracks{};
    std::optional<Vehicle> vehicle{};  // that was used
};

// The tracks that are wanted, as far as the mission has reports for them.
template <class Wanted>
Result<Heard> hearAgain(const std::filesystem::path& mission, const RecomputeOptions& options,
                        Wanted wanted) {
    const auto reader = MissionReader::open(mission);
    if (!reader) return tl::make_unexpected(reader.error());
    const auto stored = reader->vehicle();
    if (!stored) return tl::make_unexpected(stored.error());

    Receiver receiver({.vehicle = options.vehicle ? options.vehicle : *stored,
                       .start = options.start,
                       .settings = options.settings});
    Heard heard;
    const auto gather = [&] {
        for (const NamedPoints& part : receiver.takePoints()) {
            if (!wanted(part.name)) continue;
            auto& tracks = heard.tracks;
            auto track = std::find_if(tracks.begin(), tracks.end(),
                                      [&](const auto& known) { return known.name == part.name; });
            if (track == tracks.end()) track = tracks.insert(track, {part.name, {}});
            track->points.insert(track->points.end(), part.points.begin(), part.points.end());
        }
    };
    const auto fed = feedMission(*reader, receiver, gather);
    if (!fed) return tl::make_unexpected(fed.error());
    for (RecomputedTrack& track : heard.tracks) {
        const auto live = reader->estimates(track.name);
        track.as_live = live && samePoses(*live, track.points);
    }
    heard.vehicle = receiver.vehicle();
    return heard;
}

}  // namespace

Result<RecomputedTrack> recomputeTrack(const std::filesystem::path& mission,
                                       const std::string& track, const RecomputeOptions& options) {
    const EstimatorEntry* entry = findEstimator(track);
    if (track != kRobotTrack && !entry) {
        return fail(ErrorCode::kUnknownName, track, "no estimator has this name");
    }
    auto heard = hearAgain(mission, options, [&](const auto& name) { return name == track; });
    if (!heard) return tl::make_unexpected(heard.error());
    if (heard->tracks.empty()) {
        const auto key = entry ? keyMissingFor(*entry, heard->vehicle) : std::nullopt;
        if (key) return tl::make_unexpected(*key);
        return fail(ErrorCode::kNoData, mission.string(), "holds no reports for " + track);
    }
    return std::move(heard->tracks.front());
}

Result<std::vector<RecomputedTrack>> recomputeTracks(const std::filesystem::path& mission,
                                                     const RecomputeOptions& options) {
    auto heard = hearAgain(mission, options, [](const std::string&) { return true; });
    if (!heard) return tl::make_unexpected(heard.error());
    std::vector<RecomputedTrack>& tracks = heard->tracks;
    if (tracks.empty()) {
        return fail(ErrorCode::kNoData, mission.string(), "holds no reports of sensors");
    }
    // The robot may have spoken of its pose first.
    std::stable_partition(tracks.begin(), tracks.end(),
                          [](const auto& track) { return track.name != kRobotTrack; });
    return std::move(tracks);
}

}  // namespace hedr
