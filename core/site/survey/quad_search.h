#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/site/survey/edge_support.h"
#include "core/site/survey/quad_proposal.h"

namespace hedr {

// Four edges that may be a sheet or a frame. The corners run clockwise on the screen.
struct QuadCandidate {
    std::array<Point<Small>, 4> corners{};
    double support = 0.0;  // 0..1: how much of the sides is seen
};

// The best quad that four of the edges make: a large one with sides that are seen and that end at
// its corners. The inside of a sheet is brighter than its outside, that of a drawing's lines
// darker.
std::optional<QuadCandidate> bestQuad(const PhotoTones& tones,
                                      const std::vector<EdgeSupport>& edges, QuadKind kind);

}  // namespace hedr
