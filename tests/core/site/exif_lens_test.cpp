// What the Exif tags of a photo say of its focal length.
#include "core/site/raster/exif_lens.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/site/plan.h"
#include "core/site/plan_cropping.h"
#include "tests/core/site/made_images.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

// A phone: 4.25 mm on a sensor of 5.647 x 4.235 mm, 4000 x 3000 pixels.
constexpr double kPxPerMm = 4000.0 / 5.647;
constexpr ExifLens kPhone{.film_mm = 26.0,
                          .lens_mm = 4.25,
                          .sensor_px_per_mm = kPxPerMm,
                          .digital_zoom = 1.0,
                          .taken_width_px = 4000.0,
                          .taken_height_px = 3000.0};
constexpr double kTrue_px = 4.25 * kPxPerMm;

ExifLens withoutSensor(ExifLens lens = kPhone) {
    lens.sensor_px_per_mm.reset();
    return lens;
}

TEST(ExifLens, TakesTheSensorsMeasuresWhereTheFileSaysThem) {
    const auto found = focalLengthOf(kPhone, 4000, 3000);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->px, kTrue_px, 1e-9);
    EXPECT_LT(found->sigma, 0.011);
}

TEST(ExifLens, ComparesTheDiagonalsOfPictureAndFilm) {
    const auto found = focalLengthOf(withoutSensor(), 4000, 3000);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->px, 26.0 * 5000.0 / std::hypot(36.0, 24.0), 0.1);
    EXPECT_LT(std::abs(found->px / kTrue_px - 1.0), found->sigma);
}

// 26 may be 25.5 to 26.5: uniform, so that the sigma of that alone is 1 / sqrt(12) mm.
TEST(ExifLens, IsLessSureOfAShortLensForTheRounding) {
    ExifLens lens = withoutSensor();
    const double at_26_mm = focalLengthOf(lens, 4000, 3000)->sigma;
    lens.film_mm = 77.0;
    const double at_77_mm = focalLengthOf(lens, 4000, 3000)->sigma;
    EXPECT_GT(at_26_mm, 1.0 / std::sqrt(12.0) / 26.0);
    EXPECT_NEAR(at_26_mm * at_26_mm - at_77_mm * at_77_mm,
                (1.0 / 26.0 / 26.0 - 1.0 / 77.0 / 77.0) / 12.0, 1e-9);
}

TEST(ExifLens, GrowsSmallerWithThePhotoAndTurnsWithIt) {
    const auto whole = focalLengthOf(kPhone, 4000, 3000);
    EXPECT_NEAR(focalLengthOf(kPhone, 1000, 750)->px, 0.25 * whole->px, 1e-9);
    EXPECT_EQ(focalLengthOf(kPhone, 3000, 4000), whole);
}

TEST(ExifLens, IsNotKnownOfAPhotoThatWasCut) {
    EXPECT_FALSE(focalLengthOf(kPhone, 3000, 3000));
    EXPECT_FALSE(focalLengthOf(kPhone, 3000, 2000)) << "the shape of another sensor";
    ExifLens rewritten = kPhone;
    rewritten.taken_width_px = 3600.0;
    EXPECT_FALSE(focalLengthOf(rewritten, 3600, 3000)) << "by a program that says its own size";
    ExifLens zoomed = kPhone;
    zoomed.digital_zoom = 2.0;
    EXPECT_FALSE(focalLengthOf(zoomed, 4000, 3000));
}

TEST(ExifLens, DoesNotBelieveASensorThatContradictsTheFilm) {
    ExifLens odd = kPhone;
    odd.sensor_px_per_mm = 2.0 * kPxPerMm;
    EXPECT_EQ(focalLengthOf(odd, 4000, 3000), focalLengthOf(withoutSensor(), 4000, 3000));
}

TEST(ExifLens, DoesNotTakeAWholeNumberOfMillimetresForAnExactOne) {
    ExifLens rounded = kPhone;
    rounded.lens_mm = 4.0;
    EXPECT_EQ(focalLengthOf(rounded, 4000, 3000), focalLengthOf(withoutSensor(), 4000, 3000));
}

TEST(ExifLens, IsNotKnownWhereTheTagsAreAbsentOrAbsurd) {
    EXPECT_FALSE(focalLengthOf({}, 4000, 3000));
    for (const double film_mm : {0.0, 1e-9, 1e9, std::nan("")}) {
        EXPECT_FALSE(focalLengthOf({.film_mm = film_mm}, 4000, 3000)) << film_mm;
    }
    EXPECT_FALSE(focalLengthOf(kPhone, 0, 3000));
    ExifLens flat = kPhone;
    flat.taken_height_px = 1e-300;
    EXPECT_FALSE(focalLengthOf(flat, 4000, 3000));
}

class PhotoFile : public testing::Test {
  protected:
    PlanImage photoWith(const std::vector<ExifTag>& tags, int orientation = 1) const {
        const auto file = folder_.path() / "photo.jpg";
        makeImage(file, markedPaper(400, 300, 4), {.driver = "JPEG"});
        writeBytes(file, withExif(bytesOf(file), orientation, tags));
        return loadPlan(file).value();
    }

  private:
    ScratchFolder folder_;
};

const std::vector<ExifTag> kTags{
    {kExifFocalLength, 425, 100}, {kExifWidth, 4000},
    {kExifHeight, 3000},          {kExifSensorXResolution, 708340, 100},  // per centimetre
    {kExifSensorUnit, 3},         {kExifDigitalZoom, 1, 1},
    {kExifFilmFocalLength, 26}};

TEST_F(PhotoFile, SaysItsFocalLengthHoweverItWasHeld) {
    for (const int orientation : {1, 6}) {
        const PlanImage photo = photoWith(kTags, orientation);
        ASSERT_TRUE(photo.focal_length) << orientation;
        EXPECT_NEAR(photo.focal_length->px, 4.25 * 708.34 / 10.0, 0.01) << orientation;
    }
}

TEST_F(PhotoFile, SaysNothingWithoutTagsOrWithBrokenOnesOrOnceItIsCut) {
    EXPECT_FALSE(photoWith({}).focal_length);
    EXPECT_FALSE(photoWith({{kExifFilmFocalLength, 0}}).focal_length);
    EXPECT_FALSE(photoWith({{kExifFocalLength, 4, -1}, {kExifFilmFocalLength, -26}}).focal_length);
    const PlanImage whole = photoWith(kTags);
    EXPECT_FALSE(croppedPlan(whole, {0, 0, 200, 150}).value().focal_length);
}

}  // namespace
}  // namespace hedr
