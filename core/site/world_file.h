#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/frames.h"
#include "core/result.h"

namespace hedr {

struct Ground {};  // the coordinates of a map, x east, y north: metres, feet or degrees

// Reads the six numbers of a world file (.pgw, .jgw, .tfw, .wld), which place the middle of the
// first pixel. The result places its outer corner, as Plan does. `path` stands in the errors:
// kFileEmpty, kBadFormat (not six numbers), kBadValue (not finite, no area).
Result<Transform<Ground, Plan>> parseWorldFile(std::string_view text, const std::string& path);

// The world file that lies beside an image: map.pgw, map.pngw or map.wld for map.png, in capitals
// too.
std::optional<std::filesystem::path> worldFileBeside(const std::filesystem::path& image);

// Errors: those of parseWorldFile, kFileUnreadable.
Result<Transform<Ground, Plan>> loadWorldFile(const std::filesystem::path& file);

}  // namespace hedr
