// Images that say themselves where they lie.
#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"
#include "core/site/plan.h"
#include "core/site/world_file.h"
#include "tests/core/site/made_images.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const fs::path kAerial = fs::path(HEDR_SOURCE_DIR) / "../shared/data/maps/aerial";

PlanImage loaded(const fs::path& file) {
    auto plan = loadPlan(file);
    if (!plan) ADD_FAILURE() << file << ": " << plan.error().detail;
    return plan.value_or(PlanImage{{}, {{0, 0, 1, nullptr}}});
}

ErrorCode codeOf(const Result<WorldFile>& result) {
    return result ? ErrorCode::kCanceled : result.error().code;
}

TEST(WorldFile, PlacesTheMiddleOfTheFirstPixel) {
    const auto file = parseWorldFile("0.5\n0\n0\r\n-0.5\n 10,25\n+19.75\n", "a.pgw");
    ASSERT_TRUE(file) << file.error().detail;
    const auto ground_from_plan = groundFromPlan(*file);
    EXPECT_EQ(ground_from_plan * (Point<Plan>{0.5, 0.5}), (Point<Ground>{10.25, 19.75}));
    EXPECT_EQ(ground_from_plan * (Point<Plan>{2.0, 4.0}), (Point<Ground>{11.0, 18.0}));
}

TEST(WorldFile, RefusesWhatPlacesNothing) {
    EXPECT_EQ(codeOf(parseWorldFile(" \n", "a.pgw")), ErrorCode::kFileEmpty);
    EXPECT_EQ(codeOf(parseWorldFile("1\n0\n0\n-1\n5\n", "a.pgw")), ErrorCode::kBadFormat);
    EXPECT_EQ(codeOf(parseWorldFile("1\n0\n0\nx\n5\n5\n", "a.pgw")), ErrorCode::kBadFormat);
    EXPECT_EQ(codeOf(parseWorldFile("0\n0\n0\n-1\n5\n5\n", "a.pgw")), ErrorCode::kBadValue);
    EXPECT_EQ(codeOf(parseWorldFile("1e300\n0\n0\n-1e300\n5\n5\n", "a")), ErrorCode::kBadValue);
    const auto nan = parseWorldFile("1\n0\n0\nnan\n5\n5\n", "a.pgw");
    ASSERT_FALSE(nan);
    EXPECT_EQ(nan.error().code, ErrorCode::kBadValue);
    EXPECT_EQ(nan.error().subject, "a.pgw:4");
}

class Georeferenced : public testing::Test {
  protected:
    fs::path at(const std::string& name) const { return folder_.path() / name; }
    fs::path make(const std::string& name, const ImageMaking& making) const {
        makeImage(at(name), markedPaper(120, 80, 1), making);
        return at(name);
    }

  private:
    ScratchFolder folder_;
};

TEST_F(Georeferenced, LieWhereTheirWorldFileSays) {
    make("a.png", {.driver = "PNG"});
    for (const char* name : {"a.pgw", "a.PGW", "a.pngw", "a.wld"}) {
        writeBytes(at(name), "0.5\n0\n0\n-0.5\n10.25\n19.75\n");
        const PlanImage plan = loaded(at("a.png"));
        EXPECT_EQ(plan.placement, (PlanPlacement{0.5, {{10.0, -20.0}, 0.0}})) << name;
        EXPECT_FALSE(plan.geo_tie) << name;
        fs::remove(at(name));
    }
}

TEST_F(Georeferenced, AreTurnedAsTheirWorldFileSays) {
    make("a.png", {.driver = "PNG"});
    writeBytes(at("a.pgw"), "0.3\n0.4\n0.4\n-0.3\n10\n20\n");
    const PlanImage plan = loaded(at("a.png"));
    EXPECT_NEAR(plan.placement.resolution_m, 0.5, 1e-12);
    EXPECT_NEAR(plan.placement.origin.heading_rad, std::atan2(4.0, 3.0), 1e-12);
    const Point<World> first = plan.worldFromPlan() * Point<Plan>{0.5, 0.5};
    EXPECT_NEAR(first.x, 10.0, 1e-9);
    EXPECT_NEAR(first.y, 20.0, 1e-9);
}

TEST_F(Georeferenced, AreNotPlacedByABadWorldFile) {
    make("a.png", {.driver = "PNG"});
    for (const char* text : {"nan\n0\n0\n-1\n1\n1\n", "0\n0\n0\n0\n1\n1\n"}) {
        writeBytes(at("a.pgw"), text);
        const auto plan = loadPlan(at("a.png"));
        ASSERT_FALSE(plan);
        EXPECT_EQ(plan.error().code, ErrorCode::kBadValue);
        EXPECT_NE(plan.error().subject.find("a.pgw"), std::string::npos) << plan.error().subject;
    }
}

TEST_F(Georeferenced, AreWarpedWhereTheirPixelsAreSkewedOrMirrored) {
    make("a.png", {.driver = "PNG"});
    // Twice as wide as high; then y up.
    writeBytes(at("a.pgw"), "1\n0\n0\n-0.5\n10\n20\n");
    const PlanImage wide = loaded(at("a.png"));
    const PlanLevel& level = wide.levels[0];
    EXPECT_NEAR(level.width_px * wide.placement.resolution_m, 120.0, 1.5);
    EXPECT_NEAR(level.height_px * wide.placement.resolution_m, 40.0, 1.5);
    writeBytes(at("a.pgw"), "0.5\n0\n0\n0.5\n10\n20\n");
    const PlanImage mirrored = loaded(at("a.png"));
    const PlanLevel& turned = mirrored.levels[0];
    ASSERT_EQ(turned.height_px, 80);
    EXPECT_LT(turned.pixels->at(static_cast<std::size_t>(75 * turned.width_px + 5)), 60);
    EXPECT_GT(turned.pixels->at(static_cast<std::size_t>(5 * turned.width_px + 5)), 200);
}

TEST_F(Georeferenced, GetLocalMetresAndATieFromAGeoTiff) {
    const PlanImage plan = loaded(
        make("a.tif", {.affine = {{500000, 0.1, 0, 5500000, 0, -0.1}}, .system = "EPSG:32632"}));
    EXPECT_EQ(plan.placement, (PlanPlacement{0.1, {}})) << "a country's grid is far away";
    ASSERT_TRUE(plan.geo_tie);
    EXPECT_EQ(plan.geo_tie->point, (Point<World>{6.0, 4.0})) << "the middle of the image";
    EXPECT_NEAR(plan.geo_tie->at.longitude_deg, 9.0, 1e-4);
    EXPECT_NEAR(plan.geo_tie->at.latitude_deg, 49.65, 0.01);
    EXPECT_NEAR(plan.geo_tie->bearing_of_y_rad, 0.0, 1e-5) << "on the zone's middle meridian";
    // Three degrees east of it, north of the grid is 3 sin(latitude) degrees east of true north.
    const PlanImage beside = loaded(
        make("b.tif", {.affine = {{716500, 0.1, 0, 5504000, 0, -0.1}}, .system = "EPSG:32632"}));
    ASSERT_TRUE(beside.geo_tie);
    EXPECT_NEAR(degFromRad(beside.geo_tie->bearing_of_y_rad),
                (beside.geo_tie->at.longitude_deg - 9.0) *
                    std::sin(radFromDeg(beside.geo_tie->at.latitude_deg)),
                0.01);
}

TEST_F(Georeferenced, KeepASitesOwnCoordinatesAndUnit) {
    const PlanImage local = loaded(make(
        "a.tif", {.affine = {{30, 0.1, 0, 40, 0, -0.1}},
                  .system = "+proj=tmerc +lat_0=50 +lon_0=9 +k=1 +datum=WGS84 +units=m +no_defs"}));
    EXPECT_EQ(local.placement.origin.position, (Point<World>{30.0, 32.0}));
    ASSERT_TRUE(local.geo_tie);
    const PlanImage feet = loaded(
        make("b.tif",
             {.affine = {{100, 1, 0, 200, 0, -1}},
              .system = "+proj=tmerc +lat_0=50 +lon_0=9 +k=1 +datum=WGS84 +units=ft +no_defs"}));
    EXPECT_NEAR(feet.placement.resolution_m, 0.3048, 1e-12);
    EXPECT_NEAR(feet.placement.origin.position.x, 30.48, 1e-9);
}

TEST_F(Georeferenced, GetTrueMetresFromDegreesAndFromWebMaps) {
    const PlanImage degrees =
        loaded(make("a.tif", {.affine = {{10, 1e-6, 0, 60, 0, -1e-6}}, .system = "EPSG:4326"}));
    EXPECT_NEAR(degrees.levels[0].width_px * degrees.placement.resolution_m, 120e-6 * 55800.0, 0.2);
    EXPECT_NEAR(degrees.levels[0].height_px * degrees.placement.resolution_m, 80e-6 * 111412.0,
                0.2);
    ASSERT_TRUE(degrees.geo_tie);
    EXPECT_NEAR(degrees.geo_tie->at.latitude_deg, 60.0 - 40e-6, 1e-6);
    const PlanImage web =
        loaded(make("b.tif", {.affine = {{1113194, 1, 0, 8399737, 0, -1}}, .system = "EPSG:3857"}));
    EXPECT_NEAR(web.levels[0].width_px * web.placement.resolution_m, 60.0, 1.5)
        << "at 60 degrees north its metres are half as long";
    const auto off =
        loadPlan(make("c.tif", {.affine = {{10, 1, 0, 600, 0, -1}}, .system = "EPSG:4326"}));
    ASSERT_FALSE(off);
    EXPECT_EQ(off.error().code, ErrorCode::kBadValue);
}

TEST_F(Georeferenced, GiveWayToAPlacementBesideThem) {
    make("a.tif", {.affine = {{500000, 0.1, 0, 5500000, 0, -0.1}}, .system = "EPSG:32632"});
    writeBytes(at("a.toml"), "image = \"a.tif\"\nresolution_m = 2\n");
    const PlanImage plan = loaded(at("a.tif"));
    EXPECT_EQ(plan.placement.resolution_m, 2.0);
    EXPECT_FALSE(plan.geo_tie) << "it ties another frame";
}

TEST_F(Georeferenced, MayBeTilesOfAWebMap) {
    make("a.mbtiles", {.driver = "MBTiles",
                       .affine = {{1113194, 0.2986, 0, 8399737, 0, -0.2986}},
                       .system = "EPSG:3857"});
    const PlanImage plan = loaded(at("a.mbtiles"));
    EXPECT_NEAR(plan.placement.resolution_m, 0.1493, 0.005);
    ASSERT_TRUE(plan.geo_tie);
    EXPECT_NEAR(plan.geo_tie->at.latitude_deg, 60.0, 0.01);
    EXPECT_NEAR(plan.geo_tie->at.longitude_deg, 10.0, 0.01);
}

// The world files beside the real aerial images were written from their tags.
TEST(AerialImages, LieWhereTheirWorldFilesSay) {
    if (!fs::exists(kAerial)) GTEST_SKIP() << "no aerial images at " << kAerial;
    for (const char* name : {"spot_chicago_utm.tiff", "drone_ortho_center100.tif"}) {
        const PlanImage plan = loaded(kAerial / name);
        const auto world_file = loadWorldFile((kAerial / name).replace_extension(".tfw"));
        ASSERT_TRUE(world_file) << world_file.error().detail;
        const auto world_from_plan = plan.worldFromPlan();
        const auto ground_from_plan = groundFromPlan(*world_file);
        const Point<Plan> corner{0.0, static_cast<double>(plan.levels[0].height_px)};
        const auto shift = ground_from_plan * corner;
        for (const Point<Plan>& p : {Point<Plan>{0, 0}, {60, 20}, {99, 99}}) {
            const Point<World> found = world_from_plan * p;
            const Point<Ground> wanted = ground_from_plan * p;
            EXPECT_NEAR(found.x, wanted.x - shift.x, 1e-6) << name;
            EXPECT_NEAR(found.y, wanted.y - shift.y, 1e-6) << name;
        }
        EXPECT_TRUE(plan.geo_tie) << name;
    }
    EXPECT_NEAR(loaded(kAerial / "drone_ortho_center100.tif").geo_tie->at.latitude_deg, 39.664,
                0.01);
}

}  // namespace
}  // namespace hedr
