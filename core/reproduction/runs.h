#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/simulation/simulated_mission.h"
#include "core/track/evaluation.h"

namespace hedr {

// The tracks of these estimators, each with the vehicle's preset, one after the other.
std::vector<std::vector<TrackPoint>> tracksOf(const SimulatedMission& mission,
                                              std::span<const std::string_view> estimators);

Evaluation judged(const std::vector<TrackPoint>& track, const SimulatedMission& mission);

// Heading error of each point: estimate minus truth, not wrapped.
std::vector<double> headingErrorsDeg(const std::vector<TrackPoint>& track,
                                     const SimulatedMission& mission);

double median(std::vector<double> values);
double largest(std::span<const double> values);

}  // namespace hedr
