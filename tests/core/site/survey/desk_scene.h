#pragma once

#include <cstdint>
#include <vector>

#include "core/site/plan.h"
#include "core/site/survey/quad.h"
#include "tests/core/site/survey/phone_camera.h"

namespace hedr::test {

// What can be made hard for who looks for the sheet in a photo.
struct DeskOptions {
    double tilt_deg = 0.0;
    bool hand = false;         // lies over one side
    bool clutter = false;      // books and pens on the table
    bool hard_shadow = false;  // with a straight edge, across the sheet
    bool corner_outside = false;
    bool close = false;  // nothing but paper in the picture
    bool no_sheet = false;
};

struct DeskPhoto {
    PhoneCamera camera{};
    PlanLevel image{};
    Quad sheet{};    // true corners, in the order of a Quad
    Quad drawing{};  // the outer corners of the plan that is drawn on it
    double width_m = 0.0;
    double height_m = 0.0;

    double diagonal_px() const { return std::hypot(camera.width_px, camera.height_px); }
};

// A sheet with a floor plan on a table, as a phone photographs it; everything else by chance.
DeskPhoto deskPhoto(const DeskOptions& options, unsigned seed);

// The largest distance of a corner, in diagonals of the photo, for the best of the turns.
double cornerError(const Quad& found, const Quad& truth, double diagonal_px);

}  // namespace hedr::test
