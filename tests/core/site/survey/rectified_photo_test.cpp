#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "core/site/raster/exif_lens.h"
#include "core/site/survey/quad_proposal.h"
#include "core/site/survey/rectification.h"
#include "core/site/survey/sheet_format.h"
#include "tests/core/site/survey/checkerboard.h"
#include "tests/core/site/survey/jpeg_like.h"
#include "tests/core/site/survey/phone_camera.h"

// A checkerboard that a phone's camera photographs, rectified by its outer corners, has squares.
namespace hedr {
namespace {

using namespace test;

struct Shot {
    PhoneCamera camera;
    PlanLevel photo;
    Quad quad;
};

constexpr Checkerboard kBoard;
constexpr double kAspect = 16.0 / 12.0;

Shot shot(PhoneCamera camera, unsigned seed) {
    camera = framing(camera, kBoard.width_m(), kBoard.height_m());
    const auto brightness = [](Point<Table> p) { return kBoard.brightness(p.x, p.y); };
    const auto light = [&](Point<Plan> p) { return 1.0 - 0.3 * p.x / camera.width_px; };
    return {camera, jpegLike(photoOf(camera, brightness, light, 3.0, seed, 2), 85),
            quadOf(camera, kBoard.width_m(), kBoard.height_m())};
}

Quad shaken(Quad quad, double sigma_px, unsigned seed) {
    std::minstd_rand random(seed + 1);
    std::normal_distribution<double> error(0.0, sigma_px);
    for (Point<Plan>& p : quad.corners) p = p + Vector<Plan>{error(random), error(random)};
    return quad;
}

Anisotropy anisotropyOf(const Shot& shot, const Quad& quad, std::optional<double> aspect,
                        const std::optional<FocalLength>& focal_length = {}) {
    const auto r =
        rectificationOf(shot.photo.width_px, shot.photo.height_px, quad, aspect, focal_length);
    const auto flat = rectified(shot.photo, *r);
    const auto expected = [&](double x, double y) {
        const Point<Flat> p = r->flat_from_photo * shot.camera.seen({x, y});
        return Eigen::Vector2d(p.x, p.y);
    };
    return measured(kBoard, *flat, expected, 10);
}

PhoneCamera camera(double tilt_deg, double azimuth_deg, double focal_mm) {
    PhoneCamera result;
    result.tilt_rad = radFromDeg(tilt_deg);
    result.azimuth_rad = radFromDeg(azimuth_deg);
    result.focal_mm = focal_mm;
    result.principal_px = {3.0, -2.0};  // 0.24 % of the diagonal
    return result;
}

TEST(RectifiedPhoto, HasSquaresWhereTheSheetsFormatIsKnown) {
    unsigned seed = 0;
    for (const double tilt_deg : {0.0, 50.0}) {
        for (const double azimuth_deg : {0.0, 35.0}) {
            const Shot s = shot(camera(tilt_deg, azimuth_deg, 26.0), ++seed);
            const Anisotropy found = anisotropyOf(s, s.quad, kAspect);
            EXPECT_LE(found.whole, 0.001) << tilt_deg << ", " << azimuth_deg;
            EXPECT_LE(found.worst, 0.005) << tilt_deg << ", " << azimuth_deg;
        }
    }
}

TEST(RectifiedPhoto, HasSquaresByThePerspectiveAlone) {
    unsigned seed = 100;
    for (const double tilt_deg : {30.0, 50.0}) {
        for (const double azimuth_deg : {25.0, -55.0}) {
            const Shot s = shot(camera(tilt_deg, azimuth_deg, 28.0), ++seed);
            const Anisotropy found = anisotropyOf(s, s.quad, {});
            EXPECT_LE(found.whole, 0.005) << tilt_deg << ", " << azimuth_deg;
        }
    }
}

TEST(RectifiedPhoto, HasSquaresWithProposedCorners) {
    unsigned seed = 200;
    for (const double tilt_deg : {15.0, 35.0, 50.0}) {
        const Shot s = shot(camera(tilt_deg, 30.0, 27.0), ++seed);
        const auto proposal = proposeQuad(s.photo);
        ASSERT_TRUE(proposal) << tilt_deg;
        const Anisotropy found = anisotropyOf(s, proposal->quad, {});
        EXPECT_LE(found.whole, 0.005) << tilt_deg;
    }
}

// What the file of such a photo says: the length for film is a whole number, that of the lens has
// two decimals (a phone, 6.5 times smaller than film).
struct Told {
    std::optional<FocalLength> film;
    std::optional<FocalLength> sensor;
};

Told toldBy(const PhoneCamera& camera) {
    constexpr double kSmaller = 6.5;
    const double w = camera.width_px;
    const double h = camera.height_px;
    ExifLens lens{.film_mm = std::round(camera.focal_mm),
                  .digital_zoom = 1.0,
                  .taken_width_px = w,
                  .taken_height_px = h};
    Told told{focalLengthOf(lens, camera.width_px, camera.height_px), {}};
    lens.lens_mm = std::round(100.0 * camera.focal_mm / kSmaller) / 100.0;
    lens.sensor_px_per_mm = kSmaller * std::hypot(w, h) / 43.267;
    told.sensor = focalLengthOf(lens, camera.width_px, camera.height_px);
    return told;
}

// Tilted about one side, the photo says nothing of its focal length f. A relative error e of f is
// one of sin^2(tilt) * e in the shape: the lengths across the way of looking shrink by 1 + e, those
// along it do not. At 50 degrees e may be 0.85 % for 0.5 %; 26 of film stands for 25.5 to 26.5,
// 1.9 %.
double shapeErrorOf(double told_px, const PhoneCamera& camera) {
    const double sine = std::sin(camera.tilt_rad);
    return sine * sine * std::abs(std::log(told_px / camera.focal_px()));
}

constexpr double kPrincipalPointCosts = 0.003;  // 0.24 % of the diagonal off the middle

TEST(RectifiedPhoto, HasSquaresWhereTiltedAboutOneSideByTheSensorsFocalLength) {
    unsigned seed = 300;
    for (const double focal_mm : {24.4, 26.45}) {
        for (const double azimuth_deg : {0.0, 90.0}) {
            const Shot s = shot(camera(50.0, azimuth_deg, focal_mm), ++seed);
            const Anisotropy found = anisotropyOf(s, s.quad, {}, toldBy(s.camera).sensor);
            EXPECT_LE(found.whole, 0.005) << focal_mm << ", " << azimuth_deg;
        }
    }
}

TEST(RectifiedPhoto, IsAsWrongAsTheFilmsFocalLengthIsRoundedWhereTiltedAboutOneSide) {
    unsigned seed = 400;
    for (const double focal_mm : {23.55, 26.45}) {
        const Shot s = shot(camera(50.0, 0.0, focal_mm), ++seed);
        const auto told = toldBy(s.camera).film;
        ASSERT_TRUE(told);
        const double found = anisotropyOf(s, s.quad, {}, told).whole;
        EXPECT_LE(found, shapeErrorOf(told->px, s.camera) + kPrincipalPointCosts) << focal_mm;
        const auto r = rectificationOf(s.photo.width_px, s.photo.height_px, s.quad, {}, told);
        EXPECT_LE(found, 2.0 * r->aspect.sigma) << focal_mm;
    }
}

// The rounding leaves no doubt which usual format it is, and that mends the rest.
TEST(RectifiedPhoto, HasSquaresByTheLikeliestFormatWhereTheFocalLengthIsRounded) {
    unsigned seed = 500;
    for (const double focal_mm : {23.55, 26.45}) {
        const Shot s = shot(camera(50.0, 90.0, focal_mm), ++seed);
        const auto r =
            rectificationOf(s.photo.width_px, s.photo.height_px, s.quad, {}, toldBy(s.camera).film);
        const auto likely = likelyFormats(r->aspect);
        ASSERT_FALSE(likely.empty()) << focal_mm;
        EXPECT_LE(anisotropyOf(s, s.quad, likely.front().aspect).whole, 0.005) << focal_mm;
    }
}

constexpr double kMostAnisotropy = 0.005;

// In percent: without the file, with the length for film, with the sensor's, by the likeliest
// format of the former, and how far the length for film must be off by its rounding.
TEST(RectifiedPhoto, DISABLED_TableOfFocalLengths) {
    std::printf("tilt azimuth focal | phone's | film's (by its rounding) | sensor's | format's\n");
    unsigned seed = 2000;
    for (const double tilt_deg : {20.0, 35.0, 50.0}) {
        for (const double azimuth_deg : {0.0, 5.0, 15.0, 90.0}) {
            for (const double focal_mm : {22.6, 23.51, 24.49, 25.51, 26.0, 26.49, 27.51, 28.3}) {
                const Shot s = shot(camera(tilt_deg, azimuth_deg, focal_mm), ++seed);
                const Told told = toldBy(s.camera);
                const auto r =
                    rectificationOf(s.photo.width_px, s.photo.height_px, s.quad, {}, told.film);
                const auto likely = likelyFormats(r->aspect);
                std::printf("%4.0f %5.0f %5.2f | %.2f | %.2f (%.2f) | %.2f |", tilt_deg,
                            azimuth_deg, focal_mm, 100.0 * anisotropyOf(s, s.quad, {}).whole,
                            100.0 * anisotropyOf(s, s.quad, {}, told.film).whole,
                            100.0 * shapeErrorOf(told.film->px, s.camera),
                            100.0 * anisotropyOf(s, s.quad, {}, told.sensor).whole);
                ASSERT_FALSE(likely.empty());
                const double by_format = anisotropyOf(s, s.quad, likely.front().aspect).whole;
                std::printf(" %.2f (%.2f)\n", 100.0 * by_format, likely.front().probability);
                EXPECT_LE(anisotropyOf(s, s.quad, {}, told.sensor).whole, kMostAnisotropy);
                EXPECT_LE(by_format, kMostAnisotropy);
            }
        }
    }
}

// All of the figures, in percent: of the whole sheet, and the worst of any 4 x 4 corners.
TEST(RectifiedPhoto, DISABLED_Table) {
    std::printf(
        "tilt azimuth focal | exact corners | and no format | 1 px off | no format | proposed | "
        "no format | distorted (k1 -0.02) | no format\n");
    unsigned seed = 1000;
    for (const double tilt_deg : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0}) {
        for (const double azimuth_deg : {0.0, 10.0, 20.0, 45.0, 70.0, 90.0}) {
            const double focal_mm = seed % 2 == 0 ? 26.0 : 28.0;
            PhoneCamera c = camera(tilt_deg, azimuth_deg, focal_mm);
            const Shot s = shot(c, ++seed);
            const Quad off = shaken(s.quad, 1.0, seed);
            const auto proposal = proposeQuad(s.photo);
            ASSERT_TRUE(proposal) << tilt_deg << ", " << azimuth_deg;
            c.k1 = -0.02;
            const Shot bent = shot(c, seed);
            EXPECT_LE(anisotropyOf(s, s.quad, kAspect).whole, kMostAnisotropy);
            EXPECT_LE(anisotropyOf(s, proposal->quad, kAspect).whole, kMostAnisotropy);
            std::printf("%4.0f %5.0f %5.0f", tilt_deg, azimuth_deg, focal_mm);
            for (const Anisotropy& a :
                 {anisotropyOf(s, s.quad, kAspect), anisotropyOf(s, s.quad, {}),
                  anisotropyOf(s, off, kAspect), anisotropyOf(s, off, {}),
                  anisotropyOf(s, proposal->quad, kAspect), anisotropyOf(s, proposal->quad, {}),
                  anisotropyOf(bent, bent.quad, kAspect), anisotropyOf(bent, bent.quad, {})}) {
                std::printf(" | %.2f %.2f", 100.0 * a.whole, 100.0 * a.worst);
            }
            std::printf("\n");
        }
    }
}

}  // namespace
}  // namespace hedr
