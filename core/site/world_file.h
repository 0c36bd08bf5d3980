#pragma once

#include <string>
#include <string_view>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// The six numbers of a world file (.wld, .pgw, .jgw, .tfw), in its order. Units are those of the
// map that the image belongs to, x to the right (east), y up (north).
struct WorldFile {
    double x_per_column = 1.0;
    double y_per_column = 0.0;
    double x_per_row = 0.0;
    double y_per_row = -1.0;  // rows go down: negative where the image is not turned
    double first_x = 0.0;     // of the upper left pixel's centre
    double first_y = 0.0;
    friend bool operator==(const WorldFile&, const WorldFile&) = default;
};

// One number per line. Errors with path:line: kBadFormat (not six numbers), kBadValue (one that is
// not finite, an image without an area).
Result<WorldFile> parseWorldFile(std::string_view text, const std::string& path);
std::string worldFileText(const WorldFile& numbers);

// For a map in metres. A world file may shear or mirror; a placement cannot.
Transform<World, Plan> worldFromPlan(const WorldFile& numbers);
WorldFile worldFileOf(const Transform<World, Plan>& world_from_plan);

// The placement of an image of that height. Error, kBadValue: one that is sheared, mirrored or has
// pixels that are not square (by more than 1 in 1000).
Result<PlanPlacement> placementOf(const WorldFile& numbers, int height_px, const std::string& path);

}  // namespace hedr
