#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"
#include "core/site/geo_tie.h"

namespace hedr {

// A place as people write and copy it: "52.2197, 21.0122", "52.2197 N 21.0122 E", "52,2197;
// 21,0122", 52°13'11"N 21°0'44"E, south and west also by a minus; latitude first, unless letters
// say otherwise. Error, kBadValue: none of these, or not on the globe.
Result<LatLon> latLonFromText(std::string_view text);

// A point of the world as it is typed: "12.5, 3.2" are metres; what has degree signs or letters is
// a place on the globe. Errors: kBadValue (neither, or out of the tie's reach), kNoData (on the
// globe, but there is no tie).
Result<Point<World>> worldPointFromText(std::string_view text, const std::optional<GeoTie>& tie);

// To a centimetre: "52.2197000, 21.0122000".
std::string latLonText(LatLon at);

}  // namespace hedr
