#include <benchmark/benchmark.h>

#include <filesystem>

#include "core/site/plan.h"
#include "core/site/raster_file.h"

namespace hedr {
namespace {

constexpr int kSide_px = 4000;

// Walls on paper that is not quite even, like a scanned floor plan.
std::filesystem::path scannedPlan(int channels) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("hedr_bench_plan_" + std::to_string(channels) + ".png");
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    std::uint32_t noise = 1;
    for (int y = 0; y < kSide_px; ++y) {
        for (int x = 0; x < kSide_px; ++x) {
            noise = noise * 1664525U + 1013904223U;
            const bool wall = x % 400 < 6 || y % 300 < 6;
            const auto value = static_cast<std::uint8_t>(wall ? 60 : 250 - (noise >> 29U));
            pixels->insert(pixels->end(), static_cast<std::size_t>(channels), value);
        }
    }
    return savePlanImage({kSide_px, kSide_px, channels, pixels}, file) ? file : "";
}

void setPixelsProcessed(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * kSide_px * kSide_px);
}

// The reference: GDAL's decoding into our pixels, and nothing else.
void decodePlan(benchmark::State& state) {
    const auto file = scannedPlan(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(readRaster(file));
    setPixelsProcessed(state);
}

void loadPlanWithLevels(benchmark::State& state) {
    const auto file = scannedPlan(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(loadPlan(file));
    setPixelsProcessed(state);
}

BENCHMARK(decodePlan)->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK(loadPlanWithLevels)->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedr
