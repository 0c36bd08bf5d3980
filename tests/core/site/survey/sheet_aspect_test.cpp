#include "core/site/survey/sheet_aspect.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/angle.h"
#include "tests/core/site/survey/phone_camera.h"

namespace hedr {
namespace {

using namespace test;

constexpr double kWidth_m = 0.297;
constexpr double kHeight_m = 0.21;
constexpr double kTrue = kWidth_m / kHeight_m;

PhoneCamera camera(double tilt_deg, double azimuth_deg, double focal_mm = 26.0) {
    PhoneCamera result;
    result.tilt_rad = radFromDeg(tilt_deg);
    result.azimuth_rad = radFromDeg(azimuth_deg);
    result.focal_mm = focal_mm;
    return framing(result, kWidth_m, kHeight_m);
}

SheetAspect seenBy(const PhoneCamera& c) {
    return sheetAspect(quadOf(c, kWidth_m, kHeight_m), c.width_px, c.height_px);
}

TEST(SheetAspect, IsRightWhereThePhotoIsTiltedAskew) {
    for (const double tilt_deg : {10.0, 30.0, 50.0}) {
        for (const double azimuth_deg : {20.0, 45.0, -35.0, 70.0, 160.0}) {
            const SheetAspect found = seenBy(camera(tilt_deg, azimuth_deg));
            EXPECT_NEAR(found.value / kTrue, 1.0, 0.002) << tilt_deg << ", " << azimuth_deg;
        }
    }
}

TEST(SheetAspect, IsThatOfTheSidesWhereThePhotoIsFrontal) {
    const SheetAspect found = seenBy(camera(0.0, 0.0));
    EXPECT_NEAR(found.value, kTrue, 1e-6);
    EXPECT_LT(found.sigma, 0.003);
}

// Tilted about one side only, the perspective does not tell the focal length.
TEST(SheetAspect, SaysHowLittleItKnowsWhereOneSideIsTheAxis) {
    for (const double focal_mm : {24.0, 26.0, 28.0}) {
        const SheetAspect found = seenBy(camera(50.0, 0.0, focal_mm));
        EXPECT_GT(found.sigma, 0.02) << focal_mm;
        EXPECT_LT(found.sigma, 0.1) << focal_mm;
        EXPECT_LT(std::abs(found.value / kTrue - 1.0), 2.0 * found.sigma) << focal_mm;
    }
    EXPECT_LT(seenBy(camera(50.0, 45.0)).sigma, 0.01);
}

TEST(SheetAspect, LearnsTheFocalLengthOfAnotherLens) {
    for (const double focal_mm : {20.0, 50.0}) {
        const SheetAspect found = seenBy(camera(45.0, 40.0, focal_mm));
        EXPECT_NEAR(found.value / kTrue, 1.0, 0.005) << focal_mm;
    }
}

}  // namespace
}  // namespace hedr
