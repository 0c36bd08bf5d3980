#pragma once

#include "core/geometry/frames.h"
#include "core/result.h"

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

// The local plane touches the ellipsoid at the tie's point and is looked at from above: lengths are
// true there, 4 um short at 1 km and 4 m short at 100 km. Heights count as zero: at 500 m above the
// ellipsoid, ground metres are longer than these by 8 cm in a kilometre.
inline constexpr double kGeoTieReach_m = 100000.0;

// Errors of both, kBadValue: further from the tie's point than kGeoTieReach_m, a coordinate that is
// not a number, a tie that is at a pole.
Result<LatLon> latLonOf(Point<World> point, const GeoTie& tie);
Result<Point<World>> worldPointOf(LatLon at, const GeoTie& tie);

// A place that is known in the world and on the globe.
struct GeoPoint {
    Point<World> point{};
    LatLon at{};
    friend bool operator==(const GeoPoint&, const GeoPoint&) = default;
};

struct TwoPointTie {
    GeoTie tie{};                 // by the middle of the two points
    double globe_length_m = 0.0;  // between the points, by their coordinates
    double world_length_m = 0.0;  // by their places in the world; a tie does not scale
};

// Errors, kBadValue: two points that coincide (nearer than 1 cm), at a pole, further from each
// other than kGeoTieReach_m, a coordinate that is not a number.
Result<TwoPointTie> tieByTwoPoints(const GeoPoint& a, const GeoPoint& b);

}  // namespace hedr
