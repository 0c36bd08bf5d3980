#include "core/site/control_points_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

using Metric = std::vector<ControlPoint>;
using Geographic = std::vector<GeoControlPoint>;

template <class Kind>
Kind parsed(const std::string& text) {
    const auto points = parseControlPoints(text, "p.csv");
    if (!points) {
        ADD_FAILURE() << points.error().subject << ' ' << points.error().detail;
        return {};
    }
    const auto* kind = std::get_if<Kind>(&*points);
    EXPECT_TRUE(kind);
    return kind ? *kind : Kind{};
}

TEST(ControlPointsFile, ReadsMetres) {
    EXPECT_EQ(parsed<Metric>("name,plan_x_px,plan_y_px,world_x_m,world_y_m\n"
                             "door,1,2,3.5,-4\n# a note\n ,5,6,7,8\n"),
              (Metric{{"door", {1, 2}, {3.5, -4}}, {"", {5, 6}, {7, 8}}}));
    EXPECT_EQ(parsed<Metric>("plan_x_px,plan_y_px,world_x_m,world_y_m\n1,2,3,4\n"),
              (Metric{{"", {1, 2}, {3, 4}}}));
}

TEST(ControlPointsFile, ReadsDegrees) {
    EXPECT_EQ(parsed<Geographic>("plan_x_px,plan_y_px,latitude_deg,longitude_deg,name\n"
                                 "1,2,48.5,-9.25,gate\n"),
              (Geographic{{"gate", {1, 2}, {48.5, -9.25}}}));
}

TEST(ControlPointsFile, ReadsWhatQgisSavesAndLeavesOutWhatIsSwitchedOff) {
    EXPECT_EQ(
        parsed<Metric>("mapX,mapY,sourceX,sourceY,enable,dX,dY,residual\n"
                       "500000.5,5300000,120.25,-340.5,1,0,0,0\n500010,5300010,1,-2,0,0,0,0\n"
                       "500020,5300020,0,0,1,0,0,0\n"),
        (Metric{{"", {120.25, 340.5}, {500000.5, 5300000}}, {"", {0, 0}, {500020, 5300020}}}));
    EXPECT_EQ(parsed<Metric>("mapX,mapY,pixelX,pixelY,enable\n1,2,3,-4,1\n"),
              (Metric{{"", {3, 4}, {1, 2}}}));
}

TEST(ControlPointsFile, SeesThatQgisSavedDegrees) {
    for (const char* crs : {"GEOGCRS[\"WGS 84\",ENSEMBLE[]]", "GEOGCS[\"WGS 84\"]", "EPSG:4326"}) {
        EXPECT_EQ(parsed<Geographic>(std::string("#CRS: ") + crs +
                                     "\nmapX,mapY,sourceX,sourceY,enable\n9.5,48.5,3,-4,1\n"),
                  (Geographic{{"", {3, 4}, {48.5, 9.5}}}));
    }
}

constexpr const char* kQgisHead = "\nmapX,mapY,sourceX,sourceY,enable\n";

// As QGIS writes it.
const std::string kWebMercator =
    "#CRS: PROJCRS[\"WGS 84 / Pseudo-Mercator\",BASEGEOGCRS[\"WGS 84\",DATUM[\"World Geodetic "
    "System 1984\",ELLIPSOID[\"WGS 84\",6378137,298.257223563,LENGTHUNIT[\"metre\",1]]],"
    "PRIMEM[\"Greenwich\",0,ANGLEUNIT[\"degree\",0.0174532925199433]],ID[\"EPSG\",4326]],"
    "CONVERSION[\"Popular Visualisation Pseudo-Mercator\",METHOD[\"Popular Visualisation Pseudo "
    "Mercator\",ID[\"EPSG\",1024]],PARAMETER[\"Latitude of natural origin\",0,ANGLEUNIT["
    "\"degree\",0.0174532925199433]],PARAMETER[\"Longitude of natural origin\",0,ANGLEUNIT["
    "\"degree\",0.0174532925199433]],PARAMETER[\"False easting\",0,LENGTHUNIT[\"metre\",1]],"
    "PARAMETER[\"False northing\",0,LENGTHUNIT[\"metre\",1]]],CS[Cartesian,2],AXIS[\"easting (X)\""
    ",east,ORDER[1],LENGTHUNIT[\"metre\",1]],AXIS[\"northing (Y)\",north,ORDER[2],LENGTHUNIT["
    "\"metre\",1]],ID[\"EPSG\",3857]]";

TEST(ControlPointsFile, TakesWebMercatorToTheGlobe) {
    const auto points =
        parsed<Geographic>(kWebMercator + "\r" + kQgisHead + "1300000,6100000,3,-4,1\n");
    ASSERT_EQ(points.size(), 1U);
    constexpr double kRadius_m = 6378137.0;
    constexpr double kDeg = 180.0 / std::numbers::pi;
    EXPECT_NEAR(points[0].at.longitude_deg, 1300000 / kRadius_m * kDeg, 1e-10);
    EXPECT_NEAR(points[0].at.latitude_deg, std::atan(std::sinh(6100000 / kRadius_m)) * kDeg, 1e-10);
    EXPECT_EQ(points[0].plan, (Point<Plan>{3, 4}));
}

// The central meridian of zone 32: on the equator, and 0.9996 of the ellipsoid's meridian up to 48
// degrees (integrated by Simpson's rule).
TEST(ControlPointsFile, TakesOtherMetresToTheGlobe) {
    const auto points = parsed<Geographic>(std::string("#CRS: EPSG:32632") + kQgisHead +
                                           "500000,0,3,-4,1\n500000,5316300.2245,3,-4,1\n");
    ASSERT_EQ(points.size(), 2U);
    EXPECT_NEAR(points[0].at.longitude_deg, 9.0, 1e-9);
    EXPECT_NEAR(points[0].at.latitude_deg, 0.0, 1e-9);
    EXPECT_NEAR(points[1].at.longitude_deg, 9.0, 1e-9);
    EXPECT_NEAR(points[1].at.latitude_deg, 48.0, 2e-9);
}

TEST(ControlPointsFile, LeavesLocalMetresAsTheyAre) {
    const std::string local =
        "#CRS: "
        "ENGCRS[\"site\",EDATUM[\"site\"],CS[Cartesian,2],AXIS[\"x\",east,ORDER[1],LENGTHUNIT["
        "\"metre\",1]],AXIS[\"y\",north,ORDER[2],LENGTHUNIT[\"metre\",1]]]";
    for (const std::string& system : {local, std::string("#CRS: ")}) {
        EXPECT_EQ(parsed<Metric>(system + kQgisHead + "1,2,3,-4,1\n"),
                  (Metric{{"", {3, 4}, {1, 2}}}));
    }
}

void expectError(const std::string& text, ErrorCode code, const std::string& subject,
                 const std::string& detail) {
    const auto points = parseControlPoints(text, "p.csv");
    ASSERT_FALSE(points) << text;
    EXPECT_EQ(points.error().code, code) << points.error().detail;
    EXPECT_EQ(points.error().subject, subject);
    EXPECT_NE(points.error().detail.find(detail), std::string::npos) << points.error().detail;
}

TEST(ControlPointsFile, RefusesAReferenceSystemThatItCannotUse) {
    const auto refused = [](const std::string& system, const std::string& why) {
        expectError("#CRS: " + system + kQgisHead + "1,2,3,-4,1\n", ErrorCode::kBadValue, "p.csv:1",
                    why);
    };
    refused("EPSG:2263", "not in metres");  // New York, in feet
    refused("EPSG:999999", "not known");
    refused("EPSG:4978", "not known");  // from the earth's centre
    refused("PROJCRS[\"WGS 84 / UTM zone 32N\"]", "not known");
    refused("/etc/passwd", "not known");
    expectError(std::string("#CRS: EPSG:32632") + kQgisHead + "1e300,2,3,-4,1\n",
                ErrorCode::kBadValue, "p.csv:3", "not on the globe");
}

TEST(ControlPointsFile, NamesPlaceAndColumnOfWhatIsWrong) {
    const std::string head = "plan_x_px,plan_y_px,world_x_m,world_y_m\n";
    expectError("", ErrorCode::kFileEmpty, "p.csv", "");
    expectError("plan_x_px,plan_y_px,world_x_m\n", ErrorCode::kMissingColumn, "p.csv", "world_y_m");
    expectError("a,b\n", ErrorCode::kMissingColumn, "p.csv", "plan_x_px");
    expectError("mapX,mapY,sourceX,enable\n", ErrorCode::kMissingColumn, "p.csv", "sourceY");
    expectError(head + "1,2,3,4\n1,2,3\n", ErrorCode::kBadFormat, "p.csv:3", "world_y_m");
    expectError(head + "1,2,x,4\n", ErrorCode::kBadFormat, "p.csv:2", "world_x_m");
    expectError(head + "1,nan,3,4\n", ErrorCode::kBadFormat, "p.csv:2", "plan_y_px");
    expectError(head + "1,2,3,inf\n", ErrorCode::kBadFormat, "p.csv:2", "world_y_m");
    expectError(head + "1,2,3,\n", ErrorCode::kBadFormat, "p.csv:2", "world_y_m");
    expectError("plan_x_px,plan_y_px,latitude_deg,longitude_deg\n1,2,91,0\n", ErrorCode::kBadValue,
                "p.csv:2", "latitude");
    expectError("plan_x_px,plan_y_px,latitude_deg,longitude_deg,world_x_m,world_y_m\n",
                ErrorCode::kBadFormat, "p.csv:1", "not both");
}

TEST(ControlPointsFile, SaysThatItIsMissing) {
    const auto points = loadControlPoints("/no/p.csv");
    ASSERT_FALSE(points);
    EXPECT_EQ(points.error().code, ErrorCode::kFileMissing);
}

RC_GTEST_PROP(ControlPointsFile, ReadsBackWhatItWrote, (double x, double y, bool metric)) {
    static const ScratchFolder folder;
    const auto file = folder.path() / "points.csv";
    ControlPoints points;
    if (metric) {
        points = Metric{{"a; b", {x, y}, {y, -x}}, {"", {0.1, 1e-300}, {5e6, 0.3}}};
    } else {
        points = Geographic{{"a", {x, y}, {89.9, -180.0}}};
    }
    RC_ASSERT(saveControlPoints(points, file).has_value());
    const auto again = loadControlPoints(file);
    RC_ASSERT(again.has_value());
    RC_ASSERT(*again == points);
}

RC_GTEST_PROP(ControlPointsFile, WritesNoNameThatBreaksARow, (const std::string& name)) {
    static const ScratchFolder folder;
    const auto file = folder.path() / "names.csv";
    RC_ASSERT(saveControlPoints(Metric{{name, {1, 2}, {3, 4}}}, file).has_value());
    const auto again = loadControlPoints(file);
    RC_ASSERT(again.has_value());
    RC_ASSERT(std::get<Metric>(*again).front().plan == (Point<Plan>{1, 2}));
}

RC_GTEST_PROP(ControlPointsFile, NeverCrashesOnAnyText, (const std::string& text)) {
    static_cast<void>(parseControlPoints(text, "p"));
    static_cast<void>(parseControlPoints("mapX,mapY,sourceX,sourceY,enable\n" + text, "p"));
    static_cast<void>(parseControlPoints("#CRS: " + text, "p"));
    static_cast<void>(parseControlPoints("#CRS: PROJCRS[" + text + kQgisHead, "p"));
}

}  // namespace
}  // namespace hedr
