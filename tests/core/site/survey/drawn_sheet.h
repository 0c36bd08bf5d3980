#pragma once

#include <cstdint>

#include "core/site/floor_plan.h"
#include "core/site/plan.h"

namespace hedr {

// Seven rooms at a corridor, 20 m x 12 m.
FloorPlan office();

// How a floor is put on paper, and what happened to the paper.
struct SheetStyle {
    double resolution_m = 0.05;
    double turned_rad = 0.0;  // counter-clockwise, before the drawing
    bool hollow = false;      // walls are two lines
    bool doors = true;        // leaves and swing arcs, thin
    bool furniture = false;
    bool texts = true;
    double hatched_rad = 0.0;  // rooms are hatched in that direction; 0: they are not
    bool light_on_dark = false;
    double noise = 0.0;         // standard deviation of the greys
    int jpeg_quality = 0;       // 0: not compressed
    double shade = 0.0;         // how much darker the lower right corner is: 0..1
    double skewed_rad = 0.0;    // a scanner's: columns lean, rows do not
    bool photographed = false;  // aslant, and rectified by corners that are 1 px off
    std::uint64_t seed = 1;     // of furniture and noise
};

// A drawing of a floor, which lies on the sheet as sheetFromFloor says.
PlanImage drawnSheet(const FloorPlan& floor, const SheetStyle& style);
Transform<Plan, Floor> sheetFromFloor(const FloorPlan& floor, const SheetStyle& style);

}  // namespace hedr
