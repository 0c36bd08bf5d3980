#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/frames.h"
#include "core/result.h"

namespace hedr {

// A place that the robot came through.
struct TrailSample {
    Vector<World> from_middle{};
    Vector<World> direction{};  // of the way, a unit vector
};

struct TrailSamples {
    Point<World> middle{};
    std::vector<TrailSample> samples{};
};

// The newest 400 m of a trail (older ones have drifted away), every 0.25 m however slowly they were
// driven; ways that were driven again count once.
// Errors: kBadValue (not a number, or out of this world), kNoData (less than 20 m, or no turn).
Result<TrailSamples> sampleTrail(std::span<const Point<World>> trail);

// At most about `most` of them, evenly.
std::vector<TrailSample> thinned(const std::vector<TrailSample>& samples, std::size_t most);

}  // namespace hedr
