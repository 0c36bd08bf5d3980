#include "core/site/survey/rectification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/site/mip_pyramid.h"

namespace hedr {
namespace {

template <class Grey>
PlanLevel painted(int width_px, int height_px, const Grey& grey) {
    auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x) pixels->push_back(static_cast<std::uint8_t>(grey(x, y)));
    }
    return {width_px, height_px, 1, pixels};
}

int greyAt(const PlanLevel& image, Point<Flat> p) {
    return image.pixels->at(
        static_cast<std::size_t>(static_cast<int>(p.y) * image.width_px + static_cast<int>(p.x)));
}

constexpr Quad kTilted{{{{300, 150}, {700, 150}, {900, 650}, {100, 650}}}};

TEST(Rectified, GivesAFlatPhotoBackAsItIs) {
    const PlanLevel photo = painted(300, 200, [](int x, int y) { return (7 * x + 13 * y) % 256; });
    const Quad whole{{{{0, 0}, {300, 0}, {300, 200}, {0, 200}}}};
    const auto flat = rectified(photo, whole);
    ASSERT_TRUE(flat) << flat.error().detail;
    ASSERT_EQ(flat->width_px, 300);
    ASSERT_EQ(flat->height_px, 200);
    EXPECT_EQ(flat->channels, 1);
    EXPECT_EQ(*flat->pixels, *photo.pixels);
}

TEST(Rectified, MakesARectangleOfTheWantedShapeAndKeepsTheLongestSide) {
    const auto r = rectificationOf(1000, 800, kTilted, 1.6);
    ASSERT_TRUE(r) << r.error().detail;
    const auto corner = [&](std::size_t i) { return r->flat_from_photo * kTilted.corners[i]; };
    const double width_px = corner(1).x - corner(0).x;
    EXPECT_NEAR(width_px, 1.6 * std::hypot(200, 500), 1e-6) << "the left side is the longest";
    EXPECT_NEAR(corner(1).y, corner(0).y, 1e-9);
    EXPECT_NEAR(corner(2).x, corner(1).x, 1e-9);
    EXPECT_NEAR(corner(3).x, corner(0).x, 1e-9);
    EXPECT_NEAR(corner(3).y - corner(0).y, width_px / 1.6, 1e-9);
    EXPECT_EQ(r->aspect.value, 1.6);
    EXPECT_EQ(r->aspect.sigma, 0.0);
}

TEST(Rectified, KeepsWhatThePhotoShowsAroundTheQuad) {
    const PlanLevel photo = painted(1000, 800, [](int x, int y) {
        return x > 40 && x < 60 && y > 700 && y < 720 ? 0 : 200;  // lower left of the quad
    });
    const auto r = rectificationOf(1000, 800, kTilted);
    ASSERT_TRUE(r);
    const auto flat = rectified(photo, *r);
    ASSERT_TRUE(flat);
    EXPECT_EQ(greyAt(*flat, r->flat_from_photo * Point<Plan>{50, 710}), 0);
    EXPECT_EQ(greyAt(*flat, r->flat_from_photo * Point<Plan>{80, 710}), 200);
    EXPECT_EQ(greyAt(*flat, r->flat_from_photo * Point<Plan>{500, 100}), 200) << "above it";
    EXPECT_EQ(greyAt(*flat, {1.0, flat->height_px - 1.0}), 255) << "white beside the photo";
}

TEST(Rectified, DoesNotGrowWithoutLimitTowardsTheHorizon) {
    const Quad steep{{{{465, 400}, {535, 400}, {900, 780}, {100, 780}}}};
    const auto r = rectificationOf(1000, 800, steep, 1.0);
    ASSERT_TRUE(r) << r.error().detail;
    EXPECT_LE(static_cast<double>(r->width_px) * r->height_px, 3.01 * 1000 * 800);
    for (const Point<Plan>& corner : steep.corners) {
        const Point<Flat> p = r->flat_from_photo * corner;
        EXPECT_GE(p.x, -1e-6);
        EXPECT_GE(p.y, -1e-6);
        EXPECT_LE(p.x, r->width_px + 1.0);
        EXPECT_LE(p.y, r->height_px + 1.0);
    }
    const PlanLevel photo = painted(1000, 800, [](int, int) { return 100; });
    const auto flat = rectified(photo, *r);
    ASSERT_TRUE(flat);
    EXPECT_EQ(greyAt(*flat, r->flat_from_photo * Point<Plan>{500, 600}), 100);
}

// Lines of one pixel beside each other are grey from afar, not broad waves.
TEST(Rectified, AveragesWhereThePhotoIsReduced) {
    const PlanLevel photo = painted(1600, 1200, [](int x, int) { return x % 2 == 0 ? 0 : 255; });
    const Quad small{{{{700, 100}, {900, 100}, {1600, 1200}, {0, 1200}}}};
    const auto levels = mipPyramid(photo);
    const auto r = rectificationOf(1600, 1200, small, 1.0);
    ASSERT_TRUE(r);
    const PlanLevel preview = rectifiedPreview(levels, *r, 300);
    const double scale = static_cast<double>(preview.width_px) / r->width_px;
    for (int x = 600; x < 1000; x += 7) {
        const Point<Flat> p = r->flat_from_photo * Point<Plan>{x + 0.5, 1100.0};
        EXPECT_NEAR(greyAt(preview, {scale * p.x, scale * p.y}), 127, 12) << x;
    }
}

TEST(Rectified, KeepsColour) {
    auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    for (int i = 0; i < 100 * 80; ++i) pixels->insert(pixels->end(), {10, 120, 230, 255});
    const Quad quad{{{{20, 20}, {80, 20}, {90, 70}, {10, 70}}}};
    const auto flat = rectified({100, 80, 4, pixels}, quad);
    ASSERT_TRUE(flat);
    ASSERT_EQ(flat->channels, 4);
    const auto middle =
        flat->pixels->begin() + 4 * (flat->height_px / 2 * flat->width_px + flat->width_px / 2);
    EXPECT_EQ(std::vector<std::uint8_t>(middle, middle + 4),
              (std::vector<std::uint8_t>{10, 120, 230, 255}));
}

TEST(Rectified, CanBeCanceled) {
    const PlanLevel photo = painted(1000, 800, [](int, int) { return 100; });
    int calls = 0;
    const auto flat = rectified(photo, kTilted, {}, [&](double share) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
        return ++calls < 2;
    });
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::kCanceled);
    EXPECT_EQ(calls, 2);
}

TEST(Rectified, RefusesWhatIsNoShape) {
    EXPECT_EQ(rectificationOf(0, 800, kTilted).error().code, ErrorCode::kBadValue);
    for (const double aspect : {0.0, -1.0, 51.0, std::numeric_limits<double>::quiet_NaN()}) {
        const auto r = rectificationOf(1000, 800, kTilted, aspect);
        ASSERT_FALSE(r) << aspect;
        EXPECT_EQ(r.error().subject, "aspect");
    }
    const Quad crossed{{{{10, 20}, {110, 90}, {110, 20}, {10, 90}}}};
    EXPECT_EQ(rectificationOf(1000, 800, crossed).error().subject, "corners");
}

TEST(RectifiedPreview, TakesTheLevelsThatAreInMemory) {
    const PlanLevel photo = painted(1000, 800, [](int, int) { return 90; });
    std::vector<PlanLevel> levels = mipPyramid(photo);
    const auto r = rectificationOf(1000, 800, kTilted);
    ASSERT_TRUE(r);
    levels.front().pixels = nullptr;
    const PlanLevel preview = rectifiedPreview(levels, *r, 2000);
    EXPECT_EQ(greyAt(preview, {preview.width_px / 2.0, preview.height_px / 2.0}), 90);
    EXPECT_FALSE(rectifiedPreview({levels.front()}, *r, 2000).pixels);
    EXPECT_EQ(rectified(levels.front(), *r).error().code, ErrorCode::kNoData);
}

TEST(RectifiedPreview, IsTheSamePictureInSmall) {
    const PlanLevel photo =
        painted(1000, 800, [](int x, int y) { return 30 + (x + y) / 10; });  // smooth
    const auto r = rectificationOf(1000, 800, kTilted);
    ASSERT_TRUE(r);
    const auto flat = rectified(photo, *r);
    const PlanLevel preview = rectifiedPreview(mipPyramid(photo), *r, 400);
    ASSERT_TRUE(flat);
    EXPECT_LE(std::max(preview.width_px, preview.height_px), 400);
    const double scale = static_cast<double>(preview.width_px) / flat->width_px;
    for (const Point<Plan> p : {Point<Plan>{320, 200}, {600, 300}, {500, 600}, {150, 630}}) {
        const Point<Flat> at = r->flat_from_photo * p;
        EXPECT_NEAR(greyAt(preview, {scale * at.x, scale * at.y}), greyAt(*flat, at), 2);
    }
}

}  // namespace
}  // namespace hedr
