#include "ui/map/plan_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/site/mip_pyramid.h"

namespace hedr {
namespace {

constexpr int kSide_px = 1200;

// Walls two pixels wide and a hatching of one, which shows moiré where it aliases.
int inkAt(int x, int y) {
    const bool wall = x % 75 < 2 || y % 90 < 2;
    const bool hatching = y > kSide_px / 2 && (x + y / 3) % 4 == 0;
    return wall || hatching ? 0 : 255;
}

PlanImage linedPlan() {
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < kSide_px; ++y) {
        for (int x = 0; x < kSide_px; ++x)
            pixels->push_back(static_cast<std::uint8_t>(inkAt(x, y)));
    }
    return {{}, mipPyramid({kSide_px, kSide_px, 1, pixels}), {1.0, {}}};
}

double overlap(double a0, double a1, double b0, double b1) {
    return std::max(0.0, std::min(a1, b1) - std::max(a0, b0));
}

// The mean of what a pixel of the screen covers.
double areaMean(int column, int row, double scale) {
    const double left = column / scale;
    const double top = row / scale;
    const double side = 1.0 / scale;
    double sum = 0.0;
    for (int y = static_cast<int>(top); y < std::min<double>(kSide_px, top + side); ++y) {
        for (int x = static_cast<int>(left); x < std::min<double>(kSide_px, left + side); ++x) {
            sum += inkAt(x, y) * overlap(x, x + 1, left, left + side) *
                   overlap(y, y + 1, top, top + side);
        }
    }
    return sum / (side * side);
}

QImage drawn(const PlanImage& plan, double scale, int size_px) {
    const double half_m = size_px / scale / 2.0;
    const ViewTransform view{{half_m, kSide_px - half_m},
                             scale,
                             0.0,
                             static_cast<double>(size_px),
                             static_cast<double>(size_px)};
    QImage image(size_px, size_px, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    Theme plain = dayTheme();
    plain.paper = Qt::white;
    plain.wall = Qt::black;
    drawPlan(painter, plan, plain, view);
    return image;
}

// The root mean square of the difference to area averaging, in grey values. What aliases or blurs
// has 25 and more at half a size of a level.
TEST(PlanLayer, LooksLikeAreaAveragingAtEveryZoom) {
    const PlanImage plan = linedPlan();
    for (const double scale : {1.0, 0.9, 0.7, 0.55, 0.5, 0.36, 0.27}) {
        const int size_px = static_cast<int>(kSide_px * scale) - 10;
        const QImage image = drawn(plan, scale, size_px);
        double sum = 0.0;
        for (int y = 0; y < size_px; ++y) {
            for (int x = 0; x < size_px; ++x) {
                const double error = qRed(image.pixel(x, y)) - areaMean(x, y, scale);
                sum += error * error;
            }
        }
        EXPECT_LT(std::sqrt(sum / (size_px * size_px)), 20.0) << scale;
    }
}

// The mean over any wider area is right: nothing is skipped between pixels.
TEST(PlanLayer, LosesNoInkWhenItIsZoomedOut) {
    const PlanImage plan = linedPlan();
    for (const double scale : {0.9, 0.7, 0.55, 0.36, 0.27, 0.2}) {
        constexpr int kBlock_px = 60;
        const QImage image = drawn(plan, scale, 2 * kBlock_px);
        double found = 0.0;
        double wanted = 0.0;
        for (int y = kBlock_px; y < 2 * kBlock_px; ++y) {
            for (int x = kBlock_px; x < 2 * kBlock_px; ++x) {
                found += qRed(image.pixel(x, y));
                wanted += areaMean(x, y, scale);
            }
        }
        EXPECT_NEAR(found / (kBlock_px * kBlock_px), wanted / (kBlock_px * kBlock_px), 2.0)
            << scale;
    }
}

TEST(PlanLayer, DrawsACoarserLevelWhereAFineOneIsNotThere) {
    PlanImage plan = linedPlan();
    const QImage whole = drawn(plan, 0.5, 400);
    plan.levels[0].pixels = nullptr;  // as in a preview
    const QImage coarse = drawn(plan, 1.0, 400);
    EXPECT_LT(qRed(coarse.pixel(76, 40)), 200) << "a wall";
    EXPECT_EQ(qRed(coarse.pixel(40, 40)), 255);
    EXPECT_EQ(drawn(plan, 0.5, 400), whole);
    for (PlanLevel& level : plan.levels) level.pixels = nullptr;
    EXPECT_EQ(qRed(drawn(plan, 1.0, 400).pixel(76, 40)), 255) << "nothing to draw";
}

TEST(PlanLayer, ReadsOnlyTheVisiblePartOfALevelInAFile) {
    PlanImage plan = linedPlan();
    const QImage wanted = drawn(plan, 1.0, 300);
    const PlanLevel full = plan.levels[0];
    PlanPart asked;
    plan.levels[0].pixels = nullptr;
    plan.levels[0].read_part = [&](const PlanPart& part) {
        asked = part;
        return readPart(full, part);
    };
    EXPECT_EQ(drawn(plan, 1.0, 300), wanted);
    EXPECT_LE(asked.width_px, 304);
    EXPECT_LE(asked.height_px, 304);
}

}  // namespace
}  // namespace hedr
