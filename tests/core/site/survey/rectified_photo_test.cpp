#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "core/site/survey/rectification.h"
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
constexpr double kAspect = 1.4;

Shot shot(PhoneCamera camera, unsigned seed) {
    camera = framing(camera, kBoard.width_m(), kBoard.height_m());
    const auto brightness = [](Point<Table> p) { return kBoard.brightness(p.x, p.y); };
    const auto light = [&](Point<Plan> p) { return 1.0 - 0.3 * p.x / camera.width_px; };
    return {camera, jpegLike(photoOf(camera, brightness, light, 3.0, seed), 85),
            quadOf(camera, kBoard.width_m(), kBoard.height_m())};
}

Quad shaken(Quad quad, double sigma_px, unsigned seed) {
    std::minstd_rand random(seed + 1);
    std::normal_distribution<double> error(0.0, sigma_px);
    for (Point<Plan>& p : quad.corners) p = p + Vector<Plan>{error(random), error(random)};
    return quad;
}

Anisotropy anisotropyOf(const Shot& shot, const Quad& quad, std::optional<double> aspect) {
    const auto r = rectificationOf(shot.photo.width_px, shot.photo.height_px, quad, aspect);
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
    for (const double tilt_deg : {0.0, 30.0, 50.0}) {
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
    for (const double tilt_deg : {10.0, 35.0, 50.0}) {
        for (const double azimuth_deg : {25.0, -55.0}) {
            const Shot s = shot(camera(tilt_deg, azimuth_deg, 28.0), ++seed);
            const Anisotropy found = anisotropyOf(s, s.quad, {});
            EXPECT_LE(found.whole, 0.005) << tilt_deg << ", " << azimuth_deg;
        }
    }
}

// All of the figures: every kind of knowledge at every tilt and azimuth.
TEST(RectifiedPhoto, DISABLED_Table) {
    std::printf(
        "tilt azimuth focal |  format known  | perspective only | corners 1 px off, known | "
        "not known | k1 -0.02, known | not known\n");
    unsigned seed = 1000;
    for (const double tilt_deg : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0}) {
        for (const double azimuth_deg : {0.0, 10.0, 20.0, 45.0, 70.0, 90.0}) {
            for (const double focal_mm : {26.0, 28.0}) {
                PhoneCamera c = camera(tilt_deg, azimuth_deg, focal_mm);
                const Shot s = shot(c, ++seed);
                const Quad off = shaken(s.quad, 1.0, seed);
                c.k1 = -0.02;
                const Shot bent = shot(c, seed);
                std::printf("%4.0f %5.0f %5.0f", tilt_deg, azimuth_deg, focal_mm);
                for (const Anisotropy& a :
                     {anisotropyOf(s, s.quad, kAspect), anisotropyOf(s, s.quad, {}),
                      anisotropyOf(s, off, kAspect), anisotropyOf(s, off, {}),
                      anisotropyOf(bent, bent.quad, kAspect), anisotropyOf(bent, bent.quad, {})}) {
                    std::printf(" | %.3f %.3f", 100.0 * a.whole, 100.0 * a.worst);
                }
                std::printf("\n");
            }
        }
    }
}

}  // namespace
}  // namespace hedr
