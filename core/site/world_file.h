#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

struct Ground {};  // the coordinates of a map, x east, y north: metres, feet or degrees

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

// One number per line; commas for points and several in a line are read too. Errors with path:line:
// kFileEmpty, kBadFormat (not six numbers), kBadValue (one that is not finite, an image without an
// area).
Result<WorldFile> parseWorldFile(std::string_view text, const std::string& path);
// Errors: those of parseWorldFile, kFileUnreadable.
Result<WorldFile> loadWorldFile(const std::filesystem::path& file);
// The one that lies beside an image: map.pgw, map.pngw or map.wld for map.png, in capitals too.
std::optional<std::filesystem::path> worldFileBeside(const std::filesystem::path& image);
std::string worldFileText(const WorldFile& numbers);

// Both place the outer corner of the first pixel, as Plan does.
Transform<Ground, Plan> groundFromPlan(const WorldFile& numbers);
// For a map in metres. A world file may shear or mirror; a placement cannot.
Transform<World, Plan> worldFromPlan(const WorldFile& numbers);
WorldFile worldFileOf(const Transform<World, Plan>& world_from_plan);

// The placement of an image of that height. Error, kBadValue: one that is sheared, mirrored or has
// pixels that are not square (by more than 1 in 1000).
Result<PlanPlacement> placementOf(const WorldFile& numbers, int height_px, const std::string& path);

}  // namespace hedr
