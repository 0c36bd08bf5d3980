// How long the visible part of a plan of 10,000 x 10,000 pixels takes on 1920 x 1080, from memory
// and from a tiled file. The map draws it on a worker thread; meanwhile a frame is a blit of the
// last picture.
#include <benchmark/benchmark.h>

#include <QPainter>
#include <cmath>

#include "core/site/plan.h"
#include "tests/bench/plan_files.h"
#include "ui/map/plan_layer.h"

namespace hedr {
namespace {

constexpr double kWidth_px = 1920.0;
constexpr double kHeight_px = 1080.0;
constexpr PlanFile kGrey{.channels = 1, .driver = "PNG"};
constexpr PlanFile kColour{.channels = 3, .driver = "PNG"};
constexpr PlanFile kTiled{.channels = 3, .driver = "GTiff", .tiled = true};

enum class Moving { kPan, kZoom, kTurn };

// The view in a step of some movement, over the middle of a plan of 500 m.
ViewTransform viewAt(Moving moving, int step) {
    ViewTransform view{{250.0, 250.0}, 14.0, 0.0, kWidth_px, kHeight_px};
    if (moving == Moving::kPan) view.centre.x += 2.0 * (step % 40);
    if (moving == Moving::kZoom) view.pixels_per_metre = 2.0 * std::exp2(0.1 * (step % 50));
    if (moving == Moving::kTurn) view.rotation_rad = 0.1 * step;
    return view;
}

void drawPlanWhile(benchmark::State& state, const PlanFile& file, Moving moving) {
    const auto plan = loadPlan(planFile(file));
    if (!plan) return state.SkipWithError(plan.error().detail.c_str());
    QImage screen(1920, 1080, QImage::Format_RGB32);
    int step = 0;
    for ([[maybe_unused]] auto _ : state) {
        QPainter painter(&screen);
        drawPlan(painter, *plan, dayTheme(), viewAt(moving, step++));
    }
}

// The reference: QPainter draws the full size with smooth pixels, which aliases.
void drawByQPainter(benchmark::State& state) {
    const auto plan = loadPlan(planFile(kGrey));
    if (!plan) return state.SkipWithError(plan.error().detail.c_str());
    const PlanLevel& full = plan->levels.front();
    const QImage image(full.pixels->data(), full.width_px, full.height_px, full.width_px,
                       QImage::Format_Grayscale8);
    QImage screen(1920, 1080, QImage::Format_RGB32);
    for ([[maybe_unused]] auto _ : state) {
        QPainter painter(&screen);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(0, 0, 1080, 1080), image);
    }
}

BENCHMARK(drawByQPainter)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, pan_grey, kGrey, Moving::kPan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, zoom_grey, kGrey, Moving::kZoom)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, turn_grey, kGrey, Moving::kTurn)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, pan_colour, kColour, Moving::kPan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, zoom_colour, kColour, Moving::kZoom)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, turn_colour, kColour, Moving::kTurn)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, pan_tiled, kTiled, Moving::kPan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, zoom_tiled, kTiled, Moving::kZoom)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawPlanWhile, turn_tiled, kTiled, Moving::kTurn)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedr
