#pragma once

#include "core/geometry/frames.h"

namespace hedr {

struct LatLon {
    double latitude_deg = 0.0;   // WGS 84, north positive
    double longitude_deg = 0.0;  // east positive
    friend bool operator==(const LatLon&, const LatLon&) = default;
};

// Ties the mission's local metres to the globe by one point and a bearing.
struct GeoTie {
    Point<World> point{};
    LatLon at{};
    double bearing_of_y_rad = 0.0;  // of the world's y axis, clockwise from true north
    friend bool operator==(const GeoTie&, const GeoTie&) = default;
};

}  // namespace hedr
