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

Result<RecomputedTrack> recomputeTrack(const std::filesystem::path& mission,
                                       const std::string& track, const RecomputeOptions& options) {
    const EstimatorEntry* entry = findEstimator(track);
    if (track != kRobotTrack && !entry) {
        return fail(ErrorCode::kUnknownName, track, "no estimator has this name");
    }
    const auto reader = MissionReader::open(mission);
    if (!reader) return tl::make_unexpected(reader.error());
    const auto stored = reader->vehicle();
    if (!stored) return tl::make_unexpected(stored.error());

    Receiver receiver({.vehicle = options.vehicle ? options.vehicle : *stored,
                       .start = options.start,
                       .settings = options.settings});
    std::vector<TrackPoint> points;
    const auto gather = [&] {
        for (const NamedPoints& part : receiver.takePoints()) {
            if (part.name != track) continue;
            points.insert(points.end(), part.points.begin(), part.points.end());
        }
    };
    const auto fed = feedMission(*reader, receiver, gather);
    if (!fed) return tl::make_unexpected(fed.error());
    if (points.empty()) {
        const auto key = entry ? keyMissingFor(*entry, receiver.vehicle()) : std::nullopt;
        if (key) return tl::make_unexpected(*key);
        return fail(ErrorCode::kNoData, mission.string(), "holds no reports for " + track);
    }
    const auto live = reader->estimates(track);
    const bool as_live = live && samePoses(*live, points);
    return RecomputedTrack{std::move(points), as_live};
}

}  // namespace hedr
