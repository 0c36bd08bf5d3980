#include "core/site/placement_export.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "core/geometry/angle.h"
#include "core/site/placement_file.h"
#include "core/site/raster_file.h"
#include "core/site/world_file.h"
#include "core/text/text_file.h"
#include "tests/core/site/read_raster.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

const PlanPlacement kPlacement{0.1 / 3.0, {{-26.5, 1.0 / 7.0}, radFromDeg(33.0)}};
const GeoTie kTie{{3.0, -4.0}, {42.2939, -83.7133}, radFromDeg(21.0)};

PlanLevel noise(int width_px, int height_px, int channels) {
    std::mt19937 random(7);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width_px * height_px * channels));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = i % 4 == 3 && channels == 4 ? 255 : static_cast<std::uint8_t>(random());
    }
    return {width_px, height_px, channels,
            std::make_shared<const std::vector<std::uint8_t>>(std::move(pixels))};
}

class PlacementExport : public testing::Test {
  protected:
    fs::path file(const char* name) const { return folder_.path() / name; }
    ScratchFolder folder_;
};

TEST_F(PlacementExport, OfAWorldFileIsReadBackAsItWas) {
    ASSERT_TRUE(exportWorldFile(kPlacement, 480, file("a.pgw")));
    const auto back = parseWorldFile(*readTextFile(file("a.pgw")), "a.pgw");
    const auto placement = placementOf(*back, 480, "a.pgw");
    ASSERT_TRUE(placement);
    EXPECT_NEAR(placement->resolution_m, kPlacement.resolution_m, 1e-15);
    EXPECT_NEAR(placement->origin.position.x, kPlacement.origin.position.x, 1e-12);
    EXPECT_NEAR(placement->origin.position.y, kPlacement.origin.position.y, 1e-12);
    EXPECT_NEAR(placement->origin.heading_rad, kPlacement.origin.heading_rad, 1e-14);
}

TEST_F(PlacementExport, OfARosMapIsReadBackAsItWas) {
    const PlanLevel image = noise(37, 23, 1);
    ASSERT_TRUE(exportRosMap(image, kPlacement, file("my map.yaml")));
    const auto back = loadPlan(file("my map.yaml"));
    ASSERT_TRUE(back) << back.error().subject << back.error().detail;
    EXPECT_EQ(back->placement, kPlacement);
    EXPECT_EQ(back->image_file, file("my map.pgm"));
    EXPECT_EQ(*back->levels.front().pixels, *image.pixels);
}

TEST_F(PlacementExport, OfARosMapHasTheBrightnessOfColours) {
    const std::vector<std::uint8_t> pixels = {0, 0, 255, 255, 255, 255, 255, 255, 0, 255, 0, 255};
    const PlanLevel image{3, 1, 4, std::make_shared<const std::vector<std::uint8_t>>(pixels)};
    ASSERT_TRUE(exportRosMap(image, kPlacement, file("a.yaml")));
    EXPECT_EQ(*loadPlan(file("a.yaml"))->levels.front().pixels,
              (std::vector<std::uint8_t>{77, 255, 149}));
}

TEST_F(PlacementExport, OfOurOwnFileFindsTheImageInAnotherFolder) {
    const fs::path image = file("a.png");
    ASSERT_TRUE(savePlanImage(noise(8, 8, 1), image));
    fs::create_directory(file("other"));
    for (const char* name : {"plan.toml", "other/plan.toml"}) {
        ASSERT_TRUE(savePlacement({image, kPlacement}, file(name)));
        const auto back = loadPlacement(file(name));
        ASSERT_TRUE(back);
        EXPECT_TRUE(fs::equivalent(back->image_file, image)) << back->image_file;
    }
}

// Metres between where GDAL says a pixel is and where the plan has it.
double offBy_m(GDALDataset& tiff, Point<Plan> pixel, Point<World> expected) {
    std::array<double, 6> numbers{};
    EXPECT_EQ(tiff.GetGeoTransform(numbers.data()), CE_None);
    double x = numbers[0] + numbers[1] * pixel.x + numbers[2] * pixel.y;
    double y = numbers[3] + numbers[4] * pixel.x + numbers[5] * pixel.y;
    OGRSpatialReference globe;
    globe.SetWellKnownGeogCS("WGS84");
    globe.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference system = *tiff.GetSpatialRef();
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> globe_from_system(
        OGRCreateCoordinateTransformation(&system, &globe));
    EXPECT_TRUE(globe_from_system->Transform(1, &x, &y));
    const auto back = worldPointOf({y, x}, kTie);
    return back ? (*back - expected).length() : HUGE_VAL;
}

TEST_F(PlacementExport, OfAGeoTiffPutsEveryPixelWhereItIsOnTheGlobe) {
    for (const int channels : {1, 4}) {
        const PlanLevel image = noise(640, 480, channels);
        ASSERT_TRUE(exportGeoTiff(image, kPlacement, kTie, file("a.tif")));
        EXPECT_EQ(*readRaster(file("a.tif"))->pixels, *image.pixels) << channels;
        GDALAllRegister();
        const std::unique_ptr<GDALDataset> tiff(
            GDALDataset::Open(file("a.tif").c_str(), GDAL_OF_RASTER));
        ASSERT_TRUE(tiff);
        const auto world_from_plan = worldFromPlan(kPlacement, image.height_px);
        for (const Point<Plan> p :
             {Point<Plan>{0.0, 0.0}, {640.0, 0.0}, {640.0, 480.0}, {0.0, 480.0}, {320.0, 240.0}}) {
            EXPECT_LT(offBy_m(*tiff, p, world_from_plan * p), 1e-4) << p.x << ' ' << p.y;
        }
    }
}

TEST_F(PlacementExport, OfAGeoTiffIsReadBackAsItWas) {
    GeoTie to_the_north = kTie;
    to_the_north.bearing_of_y_rad = 0.0;
    ASSERT_TRUE(exportGeoTiff(noise(640, 480, 1), kPlacement, to_the_north, file("a.tif")));
    const auto back = loadPlan(file("a.tif"));
    ASSERT_TRUE(back) << back.error().detail;
    EXPECT_NEAR(back->placement.resolution_m, kPlacement.resolution_m, 1e-9);
    EXPECT_NEAR(back->placement.origin.position.x, kPlacement.origin.position.x, 1e-6);
    EXPECT_NEAR(back->placement.origin.position.y, kPlacement.origin.position.y, 1e-6);
    EXPECT_NEAR(back->placement.origin.heading_rad, kPlacement.origin.heading_rad, 1e-8);
    ASSERT_TRUE(back->geo_tie);
    const auto there = latLonOf({12.0, 34.0}, to_the_north);
    EXPECT_LT((*worldPointOf(*there, *back->geo_tie) - Point<World>{12.0, 34.0}).length(), 1e-4);
}

TEST_F(PlacementExport, OfAGeoTiffHasTilesAndOverviews) {
    ASSERT_TRUE(exportGeoTiff(noise(1200, 900, 1), kPlacement, kTie, file("a.tif")));
    const std::unique_ptr<GDALDataset> tiff(
        GDALDataset::Open(file("a.tif").c_str(), GDAL_OF_RASTER));
    int tile_width_px = 0;
    int tile_height_px = 0;
    tiff->GetRasterBand(1)->GetBlockSize(&tile_width_px, &tile_height_px);
    EXPECT_EQ(tile_height_px, 512);
    EXPECT_GE(tiff->GetRasterBand(1)->GetOverviewCount(), 1);
}

TEST_F(PlacementExport, OfAGeoTiffCanBeCanceledAndLeavesNothing) {
    const auto canceled = exportGeoTiff(noise(1200, 900, 1), kPlacement, kTie, file("a.tif"),
                                        [](double) { return false; });
    ASSERT_FALSE(canceled);
    EXPECT_EQ(canceled.error().code, ErrorCode::kCanceled);
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(PlacementExport, SaysWhyItCannotBeWritten) {
    const PlanLevel image = noise(8, 8, 1);
    const fs::path nowhere = file("none/a.tif");
    EXPECT_EQ(exportGeoTiff(image, kPlacement, kTie, nowhere).error().code,
              ErrorCode::kFileUnwritable);
    EXPECT_EQ(exportWorldFile(kPlacement, 8, nowhere).error().code, ErrorCode::kFileUnwritable);
    EXPECT_EQ(exportRosMap(image, kPlacement, nowhere).error().code, ErrorCode::kFileUnwritable);
    GeoTie pole = kTie;
    pole.at.latitude_deg = 90.0;
    EXPECT_EQ(exportGeoTiff(image, kPlacement, pole, file("a.tif")).error().code,
              ErrorCode::kBadValue);
}

}  // namespace
}  // namespace hedr
