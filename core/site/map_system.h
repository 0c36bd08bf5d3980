#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/site/geo_tie.h"
#include "core/site/world_file.h"

namespace hedr {

// Where coordinates of a map, x east and y north, lie on the globe; none for what does not.
using GlobeFinder = std::function<std::optional<LatLon>(Point<Ground>)>;

// For a projected reference system in metres, as WKT or "EPSG:3857"; none for a local one in
// metres, which has no place on the globe. `where` stands in the error, kBadValue: another unit, or
// a system that is not known.
Result<std::optional<GlobeFinder>> globeFinder(const std::string& system_text,
                                               const std::string& where);

}  // namespace hedr
