// A plan of fine lines, zoomed out and turned, beside exact area averaging.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "core/geometry/angle.h"
#include "core/site/mip_pyramid.h"
#include "ui/map/plan_layer.h"

namespace hedr {
namespace {

constexpr int kPlan_px = 3200;
constexpr int kScreen_px = 80;

using Drawing = std::function<bool(int, int)>;  // whether a pixel of the plan is ink
using Screen = std::vector<double>;             // greys, row by row

PlanImage planOf(const Drawing& ink) {
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    pixels->reserve(static_cast<std::size_t>(kPlan_px) * kPlan_px);
    for (int y = 0; y < kPlan_px; ++y) {
        for (int x = 0; x < kPlan_px; ++x) pixels->push_back(ink(x, y) ? 0 : 255);
    }
    return {{}, mipPyramid({kPlan_px, kPlan_px, 1, pixels}), {1.0, {}}};
}

ViewTransform viewAt(double scale, double rotation_deg) {
    return {
        {kPlan_px / 2.0, kPlan_px / 2.0}, scale, radFromDeg(rotation_deg), kScreen_px, kScreen_px};
}

Screen drawn(const PlanImage& plan, const ViewTransform& view) {
    QImage image(kScreen_px, kScreen_px, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    Theme plain = dayTheme();
    plain.paper = Qt::white;
    plain.wall = Qt::black;
    drawPlan(painter, plan, plain, view);
    Screen greys;
    for (int y = 0; y < kScreen_px; ++y) {
        for (int x = 0; x < kScreen_px; ++x) greys.push_back(qRed(image.pixel(x, y)));
    }
    return greys;
}

// The mean of `grey` at finer x finer places in each pixel of the screen: in its middle if that is
// one, else each anywhere in its own part of the pixel, so that they beat with no line.
Screen sampled(const PlanImage& plan, const ViewTransform& view, int finer,
               const std::function<double(Point<Plan>)>& grey) {
    const auto plan_from_view = (view.viewFromWorld() * plan.worldFromPlan()).inverse();
    std::minstd_rand random(1);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    const auto within = [&] { return finer == 1 ? 0.5 : anywhere(random); };
    Screen greys;
    for (int i = 0; i < kScreen_px * kScreen_px; ++i) {
        double sum = 0.0;
        for (int k = 0; k < finer * finer; ++k) {
            sum +=
                grey(plan_from_view * Point<View>{i % kScreen_px + (k % finer + within()) / finer,
                                                  i / kScreen_px + (k / finer + within()) / finer});
        }
        greys.push_back(sum / (finer * finer));
    }
    return greys;
}

double greyAt(const PlanLevel& level, int x, int y) {
    return (*level.pixels)[static_cast<std::size_t>(y * level.width_px + x)];
}

double nearestOf(const PlanLevel& level, Point<Plan> p) {
    return greyAt(level, static_cast<int>(p.x), static_cast<int>(p.y));
}

// The truth: the mean of what a pixel of the screen covers, exact to a grey.
Screen areaAverage(const PlanImage& plan, const ViewTransform& view) {
    return sampled(plan, view, 24,
                   [&](Point<Plan> p) { return nearestOf(plan.levels.front(), p); });
}

Screen nearestNeighbour(const PlanImage& plan, const ViewTransform& view) {
    return sampled(plan, view, 1, [&](Point<Plan> p) { return nearestOf(plan.levels.front(), p); });
}

// Exact averages of squares of the plan, four of which are mixed for a pixel of the screen.
Screen bilinearOfAverages(const PlanImage& plan, const ViewTransform& view, double square_px) {
    const int side_px = static_cast<int>(std::lround(kPlan_px / square_px));
    const double size = static_cast<double>(kPlan_px) / side_px;
    const PlanLevel level =
        areaAveraged(plan.levels.front(), {0, 0, kPlan_px, kPlan_px}, side_px, side_px);
    return sampled(plan, view, 1, [&](Point<Plan> p) {
        const double x = p.x / size - 0.5;
        const double y = p.y / size - 0.5;
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        const double right = x - column;
        const double down = y - row;
        return (1.0 - down) * ((1.0 - right) * greyAt(level, column, row) +
                               right * greyAt(level, column + 1, row)) +
               down * ((1.0 - right) * greyAt(level, column, row + 1) +
                       right * greyAt(level, column + 1, row + 1));
    });
}

// What a graphics card does: squares of the power of two that is nearest to the screen's pixel.
Screen mipWithBilinear(const PlanImage& plan, const ViewTransform& view) {
    return bilinearOfAverages(plan, view, std::exp2(std::round(-std::log2(view.pixels_per_metre))));
}

Screen averagesWithBilinear(const PlanImage& plan, const ViewTransform& view) {
    return bilinearOfAverages(plan, view, 1.0 / view.pixels_per_metre);
}

double meanOf(const Screen& greys) {
    double sum = 0.0;
    for (const double grey : greys) sum += grey;
    return sum / static_cast<double>(greys.size());
}

// Root mean square.
double difference(const Screen& a, const Screen& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// How uneven what should be one grey is: standard deviation.
double unevenness(const Screen& greys) {
    return difference(greys, Screen(greys.size(), meanOf(greys)));
}

// Lines and half lines of a plan: single walls, a grid, letters' strokes.
bool lines(int x, int y) {
    return x % 97 < 2 || y % 83 < 2 || (x + y) % 211 < 2 || (x % 40 < 20 && y % 31 == 0);
}

Drawing hatchingOf(int period_px) {
    return [period_px](int x, int) { return x % period_px == 0; };
}

// What a pixel weighs when squares of the size of one are averaged exactly and four of them mixed
// has the variance 1/12 + 1/6 per axis. The pyramid may add the square of a level's pixel / 12, at
// most a third of that, as those are no larger than the screen's: so much more may be blurred.
TEST(TurnedPlan, IsHardlyMoreBlurredThanExactAveragesThatAreTurned) {
    const PlanImage plan = planOf(lines);
    for (const double scale : {1.0 / 5.2, 1.0 / 7.0, 1.0 / 13.0}) {
        const ViewTransform view = viewAt(scale, 30.0);
        const Screen truth = areaAverage(plan, view);
        const Screen ours = drawn(plan, view);
        const double allowed = difference(averagesWithBilinear(plan, view), truth);
        EXPECT_LE(difference(ours, truth), 4.0 / 3.0 * allowed) << scale;
        EXPECT_GT(difference(nearestNeighbour(plan, view), truth), 2.0 * allowed) << scale;
        EXPECT_NEAR(meanOf(ours), meanOf(truth), 1.0) << scale << ": ink is lost";
    }
}

// Lines that are nearer to one another than two pixels of the screen should be one even grey.
// Exact averages are not quite even, the worst where the lines' distance is between one and two
// pixels; what mixes such averages must not be worse.
TEST(TurnedPlan, ShowsNoMoreMoireInItsWorstHatchingThanExactAverages) {
    const ViewTransform seventh = viewAt(1.0 / 7.0, 30.0);
    const ViewTransform fifth = viewAt(1.0 / 5.2, 30.0);
    for (const ViewTransform& view : {seventh, fifth}) {
        double worst = 0.0;
        double worst_of_averages = 0.0;
        double least_of_nearest = 255.0;
        for (const int period_px : {3, 5, 9}) {
            const PlanImage plan = planOf(hatchingOf(period_px));
            worst = std::max(worst, unevenness(drawn(plan, view)));
            worst_of_averages = std::max(worst_of_averages, unevenness(areaAverage(plan, view)));
            least_of_nearest = std::min(least_of_nearest, unevenness(nearestNeighbour(plan, view)));
        }
        EXPECT_LE(worst, worst_of_averages) << view.pixels_per_metre;
        EXPECT_GT(least_of_nearest, 2.0 * worst_of_averages) << view.pixels_per_metre;
    }
}

// The root mean square errors of lines, and the unevenness of hatchings.
TEST(TurnedPlan, DISABLED_Table) {
    std::printf(
        "scale turn | error: ours, averages+bilinear, mip+bilinear, nearest; mean | "
        "hatching: ours, upright area, turned area, averages+bilinear, mip+bilinear, nearest\n");
    const PlanImage plan = planOf(lines);
    for (const double scale : {1.0 / 7.0, 1.0 / 13.0, 1.0 / 5.2, 1.0 / 3.1, 1.0 / 1.4}) {
        for (const double turn_deg : {30.0, 7.0, 45.0}) {
            const ViewTransform view = viewAt(scale, turn_deg);
            const Screen truth = areaAverage(plan, view);
            std::printf("1/%.1f %2.0f | %.2f %.2f %.2f %.2f; %.2f |", 1.0 / scale, turn_deg,
                        difference(drawn(plan, view), truth),
                        difference(averagesWithBilinear(plan, view), truth),
                        difference(mipWithBilinear(plan, view), truth),
                        difference(nearestNeighbour(plan, view), truth),
                        meanOf(drawn(plan, view)) - meanOf(truth));
            const int between = static_cast<int>(std::lround(1.5 / scale));
            for (const int period : {3, 5, 9, between}) {
                if (period * scale > 2.0 || period < 2) continue;
                const PlanImage hatching = planOf(hatchingOf(period));
                std::printf("  p%d: %.1f %.1f %.1f %.1f %.1f %.1f", period,
                            unevenness(drawn(hatching, view)),
                            unevenness(areaAverage(hatching, viewAt(scale, 0.0))),
                            unevenness(areaAverage(hatching, view)),
                            unevenness(averagesWithBilinear(hatching, view)),
                            unevenness(mipWithBilinear(hatching, view)),
                            unevenness(nearestNeighbour(hatching, view)));
            }
            std::printf("\n");
        }
    }
}

}  // namespace
}  // namespace hedr
