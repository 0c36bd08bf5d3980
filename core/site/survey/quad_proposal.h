#pragma once

#include <optional>

#include "core/site/plan.h"
#include "core/site/survey/quad.h"

namespace hedr {

enum class QuadKind {
    kSheet,    // the outline of a sheet, brighter than what it lies on
    kDrawing,  // the outermost lines of the drawing: a frame, or outer walls
};

struct QuadProposal {
    Quad quad{};  // a corner may lie a little outside of the photo
    QuadKind kind{};
    double confidence = 0.0;  // 0..1: how much of the sides is seen as an edge
};

// Four corners that make a photo of a plan flat. None where nothing looks like a sheet, and where
// the drawing is flat as it is (a scan, an exported drawing), or the photo is not in memory.
std::optional<QuadProposal> proposeQuad(const PlanLevel& photo);

}  // namespace hedr
