#include "core/site/geo_tie.h"

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// WGS 84.
constexpr double kEquator_m = 6378137.0;  // semi-major axis
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);

constexpr double kNearestToPole_deg = 1e-3;  // 110 m: north has a meaning still
constexpr double kNearest_m = 0.01;

using Vector3 = Eigen::Vector3d;  // from the earth's centre: to longitude 0, to 90 east, to north

// On the ellipsoid.
Vector3 earthFrom(LatLon at) {
    const double latitude_rad = radFromDeg(at.latitude_deg);
    const double longitude_rad = radFromDeg(at.longitude_deg);
    const double s = std::sin(latitude_rad);
    const double normal_m = kEquator_m / std::sqrt(1.0 - kEccentricity2 * s * s);
    const double radius_m = normal_m * std::cos(latitude_rad);
    return {radius_m * std::cos(longitude_rad), radius_m * std::sin(longitude_rad),
            normal_m * (1.0 - kEccentricity2) * s};
}

// Exact for a point on the ellipsoid.
LatLon latLonFrom(const Vector3& earth) {
    const double radius_m = std::hypot(earth.x(), earth.y());
    return {degFromRad(std::atan2(earth.z(), (1.0 - kEccentricity2) * radius_m)),
            degFromRad(std::atan2(earth.y(), earth.x()))};
}

// The plane that touches the ellipsoid at a point.
struct TangentPlane {
    Vector3 point;
    Vector3 east;
    Vector3 north;
    Vector3 up;
};

TangentPlane tangentPlane(LatLon at) {
    const double sin_latitude = std::sin(radFromDeg(at.latitude_deg));
    const double cos_latitude = std::cos(radFromDeg(at.latitude_deg));
    const double sin_longitude = std::sin(radFromDeg(at.longitude_deg));
    const double cos_longitude = std::cos(radFromDeg(at.longitude_deg));
    return {earthFrom(at),
            {-sin_longitude, cos_longitude, 0.0},
            {-sin_latitude * cos_longitude, -sin_latitude * sin_longitude, cos_latitude},
            {cos_latitude * cos_longitude, cos_latitude * sin_longitude, sin_latitude}};
}

// The point of the ellipsoid below a point of the plane: the nearer root of a quadratic equation,
// in coordinates in which the ellipsoid is a unit sphere.
Vector3 ellipsoidBelow(const TangentPlane& plane, const Vector3& on_plane) {
    const Vector3 shrink = Vector3(1.0, 1.0, 1.0 / std::sqrt(1.0 - kEccentricity2)) / kEquator_m;
    const Vector3 from = on_plane.cwiseProduct(shrink);
    const Vector3 along = plane.up.cwiseProduct(shrink);
    const double a = along.squaredNorm();
    const double half_b = from.dot(along);
    const double c = from.squaredNorm() - 1.0;
    // Not (-b + root) / a, whose digits cancel near the tie.
    const double up_m = -c / (half_b + std::sqrt(half_b * half_b - a * c));
    return on_plane + up_m * plane.up;
}

struct EastNorth {
    double east_m = 0.0;
    double north_m = 0.0;
};

EastNorth eastNorthOf(const TangentPlane& plane, LatLon at) {
    const Vector3 way = earthFrom(at) - plane.point;
    return {plane.east.dot(way), plane.north.dot(way)};
}

Result<void> checkLatLon(LatLon at) {
    if (std::abs(at.latitude_deg) <= 90.0 && std::abs(at.longitude_deg) <= 360.0) return {};
    return fail(ErrorCode::kBadValue, "latitude, longitude", "must be within 90 and 180 degrees");
}

Result<void> checkTie(LatLon at) {
    if (std::abs(at.latitude_deg) <= 90.0 - kNearestToPole_deg) return checkLatLon(at);
    return fail(ErrorCode::kBadValue, "latitude", "is at a pole, where there is no north");
}

tl::unexpected<Error> tooFar() {
    const std::string reach_km = std::to_string(std::lround(kGeoTieReach_m / 1000.0));
    return fail(ErrorCode::kBadValue, "point",
                std::string("must be less than ")
                    .append(reach_km)
                    .append(" km from the place that ties the world to the globe"));
}

}  // namespace

Result<LatLon> latLonOf(Point<World> point, const GeoTie& tie) {
    if (const auto checked = checkTie(tie.at); !checked)
        return tl::make_unexpected(checked.error());
    const Vector<World> way = point - tie.point;
    if (!(way.length() <= kGeoTieReach_m)) return tooFar();
    const double s = std::sin(tie.bearing_of_y_rad);
    const double c = std::cos(tie.bearing_of_y_rad);
    const TangentPlane plane = tangentPlane(tie.at);
    const Vector3 on_plane =
        plane.point + (c * way.x + s * way.y) * plane.east + (-s * way.x + c * way.y) * plane.north;
    return latLonFrom(ellipsoidBelow(plane, on_plane));
}

Result<Point<World>> worldPointOf(LatLon at, const GeoTie& tie) {
    for (const auto& checked : {checkTie(tie.at), checkLatLon(at)}) {
        if (!checked) return tl::make_unexpected(checked.error());
    }
    const TangentPlane plane = tangentPlane(tie.at);
    // The far side of the globe, too, lies above some point of the plane.
    if (!((earthFrom(at) - plane.point).norm() <= kGeoTieReach_m)) return tooFar();
    const auto [east_m, north_m] = eastNorthOf(plane, at);
    const double s = std::sin(tie.bearing_of_y_rad);
    const double c = std::cos(tie.bearing_of_y_rad);
    return tie.point + Vector<World>{c * east_m - s * north_m, s * east_m + c * north_m};
}

Result<TwoPointTie> tieByTwoPoints(const GeoPoint& a, const GeoPoint& b) {
    for (const auto& checked : {checkTie(a.at), checkTie(b.at)}) {
        if (!checked) return tl::make_unexpected(checked.error());
    }
    const Vector<World> way = b.point - a.point;
    const double chord_m = (earthFrom(b.at) - earthFrom(a.at)).norm();
    if (way.length() < kNearest_m || chord_m < kNearest_m)
        return fail(ErrorCode::kBadValue, "two points", "must not be the same place");
    if (!(way.length() <= kGeoTieReach_m && chord_m <= kGeoTieReach_m)) return tooFar();

    const TangentPlane plane_at_a = tangentPlane(a.at);
    const Vector3 middle = 0.5 * (plane_at_a.point + earthFrom(b.at));
    const LatLon at = latLonFrom(ellipsoidBelow(plane_at_a, middle));
    const TangentPlane plane = tangentPlane(at);
    const EastNorth from = eastNorthOf(plane, a.at);
    const EastNorth to = eastNorthOf(plane, b.at);
    const double east_m = to.east_m - from.east_m;
    const double north_m = to.north_m - from.north_m;
    const double bearing_of_way_rad = std::atan2(east_m, north_m);
    const double way_from_y_rad = std::atan2(way.x, way.y);  // clockwise
    return TwoPointTie{{a.point + 0.5 * way, at, wrapAngle(bearing_of_way_rad - way_from_y_rad)},
                       std::hypot(east_m, north_m),
                       way.length()};
}

}  // namespace hedr
