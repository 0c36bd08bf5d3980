// Opens one plan in a process of its own, as the map does: loads it and draws what fills a screen.
// Prints the seconds that it took and the most memory that the process ever had, in bytes.
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <chrono>
#include <iostream>

#include "core/site/plan.h"
#include "tests/bench/memory.h"
#include "ui/map/plan_layer.h"

namespace hedr {
namespace {

constexpr int kWidth_px = 1920;
constexpr int kHeight_px = 1080;

// The whole plan in the middle of the screen.
ViewTransform wholeOf(const PlanImage& plan) {
    const auto [min, max] = planBounds(plan);
    return {{0.5 * (min.x + max.x), 0.5 * (min.y + max.y)},
            std::min(kWidth_px / (max.x - min.x), kHeight_px / (max.y - min.y)),
            0.0,
            kWidth_px,
            kHeight_px};
}

int run(const char* file) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto plan = loadPlan(file);
    if (!plan) {
        std::cerr << plan.error().subject << ": " << plan.error().detail << '\n';
        return 1;
    }
    QImage screen(kWidth_px, kHeight_px, QImage::Format_RGB32);
    QPainter painter(&screen);
    drawPlan(painter, *plan, dayTheme(), wholeOf(*plan));
    painter.end();
    std::cout << std::chrono::duration<double>(Clock::now() - start).count() << ' '
              << peakMemory_bytes() << '\n';
    return 0;
}

}  // namespace
}  // namespace hedr

int main(int argc, char** argv) {
    if (argc == 2) return hedr::run(argv[1]);
    std::cerr << "usage: hedr_first_view FILE\n";
    return 2;
}
