#pragma once

#include <vector>

#include "core/site/plan.h"
#include "core/site/wall_stroke.h"
#include "ui/map/base_image.h"
#include "ui/site/choices_panel.h"

namespace hedr {

// Where a plan may lie, found by the program, with a picture of each.
struct PlacementProposals {
    QString verdict{};  // what was found, and what to do
    std::vector<PlanPlacement> placements{};
    std::vector<Choice> choices{};  // one for each placement
};

// What proposals are made from: a snapshot, for a worker.
struct ProposalBasis {
    MapPlan plan{};     // where it lies now
    MapScene trails{};  // without plans; the primary trail is the last one
    std::vector<WallStroke> wall_strokes{};
    double direction_rad = 0.0;  // of the corridors in the world
    double device_ratio = 1.0;
};

// Turned so that the plan's main lines lie along the world's corridors. Errors: kCanceled, those of
// findDirections.
Result<PlacementProposals> proposeTurns(const ProposalBasis& basis, const PlanProgress& progress);

// Laid so that the primary trail runs along the plan's corridors. Errors: those of freeSpaceOf and
// placeByTrail.
Result<PlacementProposals> proposeByTrail(const ProposalBasis& basis, const PlanProgress& progress);

}  // namespace hedr
