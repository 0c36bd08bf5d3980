#include "core/site/control_points_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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
        parsed<Metric>("#CRS: PROJCRS[\"WGS 84 / UTM zone 32N\",BASEGEOGCRS[\"WGS 84\"]]\n"
                       "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual\n"
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

void expectError(const std::string& text, ErrorCode code, const std::string& subject,
                 const std::string& detail) {
    const auto points = parseControlPoints(text, "p.csv");
    ASSERT_FALSE(points) << text;
    EXPECT_EQ(points.error().code, code) << points.error().detail;
    EXPECT_EQ(points.error().subject, subject);
    EXPECT_NE(points.error().detail.find(detail), std::string::npos) << points.error().detail;
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
}

}  // namespace
}  // namespace hedr
