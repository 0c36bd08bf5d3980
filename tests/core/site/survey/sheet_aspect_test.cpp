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

SheetAspect seenBy(const PhoneCamera& c, const std::optional<FocalLength>& told = {}) {
    return sheetAspect(quadOf(c, kWidth_m, kHeight_m), c.width_px, c.height_px, told);
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

TEST(SheetAspect, BelievesTheFocalLengthThatItIsToldWhereOneSideIsTheAxis) {
    for (const double focal_mm : {20.0, 26.0, 50.0}) {
        const PhoneCamera c = camera(50.0, 0.0, focal_mm);
        const SheetAspect found = seenBy(c, FocalLength{c.focal_px(), 0.005});
        EXPECT_NEAR(found.value / kTrue, 1.0, 0.001) << focal_mm;
        // sin^2(50 deg) = 0.587 of its sigma and of an error in it.
        const double of_the_rest = seenBy(c, FocalLength{c.focal_px(), 1e-6}).sigma;
        EXPECT_NEAR(std::sqrt(found.sigma * found.sigma - of_the_rest * of_the_rest), 0.00293,
                    0.0003)
            << focal_mm;
        const SheetAspect off = seenBy(c, FocalLength{1.01 * c.focal_px(), 0.005});
        EXPECT_NEAR(std::abs(std::log(off.value / kTrue)), 0.00587, 0.0003) << focal_mm;
    }
}

TEST(SheetAspect, WeighsThePerspectiveAgainstAFocalLengthThatIsWrong) {
    const PhoneCamera c = camera(50.0, 45.0);
    const FocalLength wrong{1.06 * c.focal_px(), 0.02};
    EXPECT_LT(std::abs(std::log(seenBy(c, wrong).value / kTrue)), 0.06 * 0.587 / 5.0);
}

TEST(SheetAspect, LearnsTheFocalLengthOfAnotherLens) {
    for (const double focal_mm : {20.0, 50.0}) {
        const SheetAspect found = seenBy(camera(45.0, 40.0, focal_mm));
        EXPECT_NEAR(found.value / kTrue, 1.0, 0.005) << focal_mm;
    }
}

}  // namespace
}  // namespace hedr
