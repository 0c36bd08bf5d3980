#include "core/site/geo_tie.h"

#include <geodesic.h>  // PROJ's geodesics, for comparison
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

geod_geodesic wgs84() {
    geod_geodesic ellipsoid;
    geod_init(&ellipsoid, 6378137.0, 1.0 / 298.257223563);
    return ellipsoid;
}

LatLon reached(LatLon from, double azimuth_deg, double distance_m) {
    const geod_geodesic ellipsoid = wgs84();
    LatLon to;
    double azimuth_there_deg = 0.0;
    geod_direct(&ellipsoid, from.latitude_deg, from.longitude_deg, azimuth_deg, distance_m,
                &to.latitude_deg, &to.longitude_deg, &azimuth_there_deg);
    return to;
}

double distance_m(LatLon a, LatLon b) {
    const geod_geodesic ellipsoid = wgs84();
    double distance = 0.0;
    double azimuth_a_deg = 0.0;
    double azimuth_b_deg = 0.0;
    geod_inverse(&ellipsoid, a.latitude_deg, a.longitude_deg, b.latitude_deg, b.longitude_deg,
                 &distance, &azimuth_a_deg, &azimuth_b_deg);
    return distance;
}

double anyOf(double least, double most) {
    return least + (most - least) * 1e-6 * *rc::gen::inRange(0, 1000001);
}

GeoTie anyTie() {
    return {{anyOf(-500.0, 500.0), anyOf(-500.0, 500.0)},
            {anyOf(-89.0, 89.0), anyOf(-180.0, 180.0)},
            anyOf(-kPi, kPi)};
}

// Where PROJ's geodesic of that azimuth (of the world, clockwise from its y axis) and length ends.
Point<World> inWorld(const GeoTie& tie, double azimuth_rad, double length_m) {
    return tie.point + length_m * Vector<World>{std::sin(azimuth_rad), std::cos(azimuth_rad)};
}

RC_GTEST_PROP(GeoTie, AgreesWithGeodesicsToAMillimetreInAKilometre, ()) {
    const GeoTie tie = anyTie();
    const double azimuth_rad = anyOf(-kPi, kPi);
    const double length_m = anyOf(0.0, 1000.0);
    const Point<World> point = inWorld(tie, azimuth_rad, length_m);
    const LatLon at = reached(tie.at, degFromRad(azimuth_rad + tie.bearing_of_y_rad), length_m);

    const auto there = latLonOf(point, tie);
    RC_ASSERT(there.has_value());
    RC_ASSERT(distance_m(*there, at) < 1e-3);
    const auto back = worldPointOf(at, tie);
    RC_ASSERT(back.has_value());
    RC_ASSERT((*back - point).length() < 1e-3);
}

RC_GTEST_PROP(GeoTie, ComesBackToTheSamePointFromAnywhereInItsReach, ()) {
    const GeoTie tie = anyTie();
    const Point<World> point = inWorld(tie, anyOf(-kPi, kPi), anyOf(0.0, 0.999 * kGeoTieReach_m));
    const auto at = latLonOf(point, tie);
    RC_ASSERT(at.has_value());
    const auto back = worldPointOf(*at, tie);
    RC_ASSERT(back.has_value());
    RC_ASSERT((*back - point).length() < 1e-6);
}

TEST(GeoTie, KnowsItsShortfallFarAway) {
    const GeoTie tie{{}, {45.0, 10.0}, 0.0};
    const auto shortfall_m = [&](double length_m) {
        return length_m - worldPointOf(reached(tie.at, 90.0, length_m), tie)->x;
    };
    EXPECT_NEAR(shortfall_m(1000.0), 4e-6, 0.5e-6);
    EXPECT_NEAR(shortfall_m(99900.0), 4.0, 0.5);
}

TEST(GeoTie, TurnsByTheBearing) {
    const GeoTie east_up{{}, {50.0, 8.0}, radFromDeg(90.0)};
    const auto at = latLonOf({0.0, 100.0}, east_up);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->latitude_deg, 50.0, 1e-7);
    EXPECT_GT(at->longitude_deg, 8.001);
}

TEST(GeoTie, CrossesTheDateLine) {
    const GeoTie tie{{}, {10.0, 179.9999}, 0.0};
    const auto at = latLonOf({1000.0, 0.0}, tie);
    ASSERT_TRUE(at);
    EXPECT_LT(at->longitude_deg, -179.9);
    EXPECT_NEAR(worldPointOf({10.0, 180.0001}, tie)->x, worldPointOf({10.0, -179.9999}, tie)->x,
                1e-6);
}

RC_GTEST_PROP(GeoTie, OfTwoPointsIsTheOneThatTheyWereTakenFrom, ()) {
    const GeoTie tie = anyTie();
    const auto anyPoint = [&] { return inWorld(tie, anyOf(-kPi, kPi), anyOf(0.0, 500.0)); };
    const Point<World> a = anyPoint();
    const Point<World> b = anyPoint();
    RC_PRE((b - a).length() > 20.0);
    const auto found = tieByTwoPoints({a, *latLonOf(a, tie)}, {b, *latLonOf(b, tie)});
    RC_ASSERT(found.has_value());
    RC_ASSERT(std::abs(found->globe_length_m - found->world_length_m) < 1e-3);
    for (const Point<World> p : {a, b, anyPoint()}) {
        const auto at = latLonOf(p, tie);
        RC_ASSERT((*worldPointOf(*at, found->tie) - p).length() < 1e-3);
    }
}

TEST(GeoTie, OfTwoPointsTellsWhereTheirLengthsDiffer) {
    const LatLon a{48.0, 11.0};
    const auto found = tieByTwoPoints({{0.0, 0.0}, a}, {{0.0, 103.0}, reached(a, 30.0, 100.0)});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->globe_length_m, 100.0, 1e-3);
    EXPECT_EQ(found->world_length_m, 103.0);
    EXPECT_NEAR(degFromRad(found->tie.bearing_of_y_rad), 30.0, 1e-3);
    EXPECT_EQ(found->tie.point, (Point<World>{0.0, 51.5}));
}

TEST(GeoTie, RefusesWhatIsNoTie) {
    const GeoPoint a{{0.0, 0.0}, {48.0, 11.0}};
    const GeoPoint b{{10.0, 0.0}, {48.0, 11.0002}};
    ASSERT_TRUE(tieByTwoPoints(a, b));
    EXPECT_EQ(tieByTwoPoints(a, a).error().detail, "must not be the same place");
    EXPECT_EQ(tieByTwoPoints(a, {b.point, a.at}).error().detail, "must not be the same place");
    EXPECT_EQ(tieByTwoPoints(a, {a.point, b.at}).error().detail, "must not be the same place");
    EXPECT_EQ(tieByTwoPoints({{0.0, 0.0}, {90.0, 0.0}}, b).error().detail,
              "is at a pole, where there is no north");
    EXPECT_FALSE(tieByTwoPoints(a, {b.point, {-48.0, 191.0}}));
    EXPECT_FALSE(tieByTwoPoints(a, {{1e9, 0.0}, b.at}));
}

TEST(GeoTie, RefusesWhatIsOutOfItsReach) {
    const GeoTie tie{{}, {48.0, 11.0}, 0.0};
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(latLonOf({kNan, 0.0}, tie));
    EXPECT_FALSE(latLonOf({100001.0, 0.0}, tie));
    EXPECT_FALSE(worldPointOf({kNan, 0.0}, tie));
    EXPECT_FALSE(worldPointOf({48.0, kNan}, tie));
    EXPECT_FALSE(worldPointOf({-48.0, -169.0}, tie));  // the other side of the globe
    EXPECT_FALSE(latLonOf({}, {{}, {-90.0, 0.0}, 0.0}));
    EXPECT_FALSE(latLonOf({}, {{}, {kNan, 0.0}, 0.0}));
}

}  // namespace
}  // namespace hedr
