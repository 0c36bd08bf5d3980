#include "core/reproduction/runs.h"

#include <algorithm>
#include <cassert>

#include "core/fusion/tracker.h"
#include "core/geometry/angle.h"

namespace hedr {

std::vector<std::vector<TrackPoint>> tracksOf(const SimulatedMission& mission,
                                              std::span<const std::string_view> estimators) {
    Tracker::Setup setup{.vehicle = mission.vehicle,
                         .config = fusionPreset(mission.vehicle),
                         .start = mission.start};
    for (const std::string_view name : estimators) {
        setup.estimators.push_back(findEstimator(name));
        assert(setup.estimators.back());
    }
    Tracker tracker(setup);
    std::vector<std::vector<TrackPoint>> tracks(estimators.size());
    for (auto& track : tracks) track.reserve(mission.sensors.size());
    for (const SensorReport& report : mission.sensors) {
        if (!tracker.add(report)) continue;
        for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].push_back(tracker.point(i));
    }
    return tracks;
}

Evaluation judged(const std::vector<TrackPoint>& track, const SimulatedMission& mission) {
    return evaluate(track, mission.truth, Alignment::kStart).value();
}

std::vector<double> headingErrorsDeg(const std::vector<TrackPoint>& track,
                                     const SimulatedMission& mission) {
    assert(track.size() == mission.truth.size());
    std::vector<double> errors;
    errors.reserve(track.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
        errors.push_back(degFromRad(track[i].pose.heading_rad - mission.truth[i].pose.heading_rad));
    }
    return errors;
}

double median(std::vector<double> values) {
    assert(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double largest(std::span<const double> values) {
    assert(!values.empty());
    return *std::max_element(values.begin(), values.end());
}

}  // namespace hedr
