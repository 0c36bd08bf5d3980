#include "radio/recomputation.h"

#include <algorithm>
#include <utility>

#include "core/fusion/estimators.h"
#include "core/mission/mission_reader.h"

namespace hedr {

namespace {

// Whether a live track came by every point that was recorded of it, to the last bit. A mission
// keeps a point now and then, and no variances.
bool passesThrough(const std::vector<TrackPoint>& track, const std::vector<TrackPoint>& recorded) {
    auto next = track.begin();
    for (const TrackPoint& point : recorded) {
        next = std::find_if(next, track.end(),
                            [&point](const TrackPoint& each) { return each.t_s == point.t_s; });
        if (next == track.end() || next->pose != point.pose ||
            next->gyro_bias_rad_s != point.gyro_bias_rad_s) {
            return false;
        }
    }
    return !recorded.empty();
}

// What keeps an estimator from working with this mission.
std::optional<Error> inputMissingFor(const EstimatorEntry& entry, const EstimatorInputs& given,
                                     const std::string& mission, const std::string& vehicle) {
    const auto missing = missingInput(entry.needs, given);
    if (!missing) return std::nullopt;
    const std::string what =
        std::string(missing->what) + ", which " + std::string(entry.name) + " needs";
    if (missing->in_vehicle) return Error{ErrorCode::kMissingKey, "the vehicle " + vehicle, what};
    return Error{ErrorCode::kNoData, mission, "it has " + what};
}

}  // namespace

Result<std::vector<RejectedFrame>> rejectedIn(const MissionReader& mission) {
    return mission.rejected().map([](const std::vector<RejectedRow>& rows) {
        std::vector<RejectedFrame> rejected;
        rejected.reserve(rows.size());
        for (const RejectedRow& row : rows)
            rejected.push_back({row.frame, static_cast<RejectReason>(row.reason)});
        return rejected;
    });
}

Result<void> feedMission(const MissionReader& mission, Receiver& receiver,
                         const std::function<void(const StreamRow&)>& after_each_row) {
    return mission.forEachStreamRow([&](const StreamRow& row) {
        if (row.kind == StreamKind::kBytes) receiver.feed(row.data);
        if (row.kind == StreamKind::kPortOpened) receiver.portOpened();
        if (row.kind == StreamKind::kDirection) receiver.setDirection(unpackDirection(row.data));
        if (after_each_row) after_each_row(row);
        return true;
    });
}

namespace {

struct Heard {
    std::vector<RecomputedTrack> tracks{};
    std::vector<SensorStretch> stretches{};
    std::optional<Vehicle> vehicle{};  // that was used; none without reports
    EstimatorInputs given{};
    SigningCounters signing{};
    std::optional<SalvageReport> salvaged{};
};

Result<FrameVerifier> verifierFor(const MissionReader& mission,
                                  const std::optional<RobotKey>& key) {
    if (key) return FrameVerifier({{key->name, key->key}}, FrameVerifier::Policy::kSignedOnly);
    return rejectedIn(mission).map([](const std::vector<RejectedFrame>& rejected) {
        return FrameVerifier::recomputing(rejected);
    });
}

// Why a mission has no track at all.
Error whyNone(const Heard& heard, const std::filesystem::path& mission, bool with_key,
              const std::string& what) {
    const SigningCounters& signing = heard.signing;
    const bool strange = signing.signed_frames == 0 && signing.no_key + signing.bad_tag > 0;
    if (strange && !with_key)
        return {ErrorCode::kMissionSigned, mission.string(),
                "its robot signs, and it was recorded without the robot's key"};
    if (strange)
        return {ErrorCode::kMissionSigned, mission.string(),
                "its robot signs, but not with this key"};
    if (with_key && signing.signed_frames == 0)
        return {ErrorCode::kBadValue, "The key",
                "is of no use: nothing in " + mission.string() + " is signed"};
    return {ErrorCode::kNoData, mission.string(), "holds no reports " + what};
}

RecomputedTrack& trackOf(std::vector<RecomputedTrack>& tracks, const std::string& name) {
    const auto track = std::find_if(tracks.begin(), tracks.end(),
                                    [&](const auto& known) { return known.name == name; });
    return track != tracks.end() ? *track : tracks.emplace_back(RecomputedTrack{name, {}});
}

void keepSensors(std::vector<HeardSensors>&& sensors, Heard& heard, std::uint64_t& boot) {
    for (HeardSensors& each : sensors) {
        if (heard.stretches.empty() || each.boot != boot) heard.stretches.emplace_back();
        boot = each.boot;
        heard.stretches.back().reports.push_back(std::move(each.report));
    }
}

// The tracks that are wanted, as far as the mission has reports for them.
template <class Wanted>
Result<Heard> hearAgain(const std::filesystem::path& mission, const RecomputeOptions& options,
                        Wanted wanted, bool keeps_sensors = false) {
    const auto reader = MissionReader::open(mission);
    if (!reader) return tl::make_unexpected(reader.error());
    const auto stored = reader->vehicle();
    if (!stored) return tl::make_unexpected(stored.error());

    auto verifier = verifierFor(*reader, options.key);
    if (!verifier) return tl::make_unexpected(verifier.error());

    Receiver receiver({.vehicle = options.vehicle ? options.vehicle : *stored,
                       .start = options.start,
                       .settings = options.settings,
                       .verifier = std::move(*verifier),
                       .keeps_sensors = keeps_sensors});
    Heard heard;
    std::uint64_t boot = 0;
    const auto gather = [&](const StreamRow&) {
        keepSensors(receiver.takeSensors(), heard, boot);
        const std::vector<NamedStatus> statuses = receiver.statuses();
        for (const NamedPoints& part : receiver.takePoints()) {
            if (!wanted(part.name)) continue;
            RecomputedTrack& track = trackOf(heard.tracks, part.name);
            track.points.insert(track.points.end(), part.points.begin(), part.points.end());
            for (const NamedStatus& known : statuses) {
                if (known.name == part.name)
                    track.lost.note(known.status.lost, track.points.back().t_s);
            }
        }
    };
    const auto fed = feedMission(*reader, receiver, gather);
    if (!fed) return tl::make_unexpected(fed.error());
    for (RecomputedTrack& track : heard.tracks) {
        const auto live = reader->estimates(track.name);
        track.as_live = live && passesThrough(track.points, *live);
    }
    heard.vehicle = receiver.vehicle();
    heard.given = receiver.inputs();
    heard.signing = receiver.verifier().counters();
    heard.salvaged = reader->salvaged();
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
        const auto missing =
            entry && heard->vehicle
                ? inputMissingFor(*entry, heard->given, mission.string(), heard->vehicle->name)
                : std::nullopt;
        if (missing) return tl::make_unexpected(*missing);
        return tl::make_unexpected(
            whyNone(*heard, mission, options.key.has_value(), "for " + track));
    }
    heard->tracks.front().salvaged = heard->salvaged;
    return std::move(heard->tracks.front());
}

Result<RecomputedTracks> recomputeTracks(const std::filesystem::path& mission,
                                         const RecomputeOptions& options) {
    auto heard = hearAgain(mission, options, [](const std::string&) { return true; });
    if (!heard) return tl::make_unexpected(heard.error());
    std::vector<RecomputedTrack>& tracks = heard->tracks;
    if (tracks.empty()) {
        return tl::make_unexpected(whyNone(*heard, mission, options.key.has_value(), "of sensors"));
    }
    // The robot may have spoken of its pose first.
    std::stable_partition(tracks.begin(), tracks.end(),
                          [](const auto& track) { return track.name != kRobotTrack; });
    return RecomputedTracks{std::move(tracks), heard->given, heard->salvaged};
}

Result<MissionSensors> sensorsIn(const std::filesystem::path& mission,
                                 const std::optional<RobotKey>& key) {
    constexpr bool kKeepsSensors = true;
    auto heard = hearAgain(
        mission, {.key = key}, [](const std::string&) { return false; }, kKeepsSensors);
    if (!heard) return tl::make_unexpected(heard.error());
    if (heard->stretches.empty() || !heard->vehicle) {
        return tl::make_unexpected(whyNone(*heard, mission, key.has_value(), "of sensors"));
    }
    return MissionSensors{std::move(heard->stretches), *heard->vehicle, heard->salvaged};
}

}  // namespace hedr
