// A plan of 10,000 x 10,000 pixels from its file into memory, beside the bare decoding by QImage,
// OpenCV and GDAL, and until there is something to see.
#include <benchmark/benchmark.h>
#include <gdal_priv.h>

#include <QImageReader>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string>

#include "core/site/plan.h"
#include "tests/bench/memory.h"
#include "tests/bench/plan_files.h"

namespace hedr {
namespace {

constexpr PlanFile kGreyPng{.channels = 1, .driver = "PNG"};
constexpr PlanFile kColourPng{.channels = 3, .driver = "PNG"};
constexpr PlanFile kJpeg{.channels = 3, .driver = "JPEG"};
constexpr PlanFile kTiledTiff{.channels = 3, .driver = "GTiff", .tiled = true};
constexpr PlanFile kGigabyteTiff{
    .side_px = 18'600, .channels = 3, .driver = "GTiff", .tiled = true};  // 1.04 GB

void decodeByQImage(benchmark::State& state, const PlanFile& plan) {
    const QString file = QString::fromStdString(planFile(plan).string());
    QImageReader::setAllocationLimit(0);
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(QImageReader(file).read());
}

void decodeByOpenCv(benchmark::State& state, const PlanFile& plan) {
    const auto file = planFile(plan).string();
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(cv::imread(file, cv::IMREAD_UNCHANGED));
    }
}

void decodeByGdal(benchmark::State& state, const PlanFile& plan) {
    const auto file = planFile(plan);
    for ([[maybe_unused]] auto _ : state) {
        // The others take fresh memory too.
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(plan.side_px) *
                                         static_cast<std::size_t>(plan.side_px * plan.channels));
        const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str()));
        benchmark::DoNotOptimize(dataset->RasterIO(
            GF_Read, 0, 0, plan.side_px, plan.side_px, pixels.data(), plan.side_px, plan.side_px,
            GDT_Byte, plan.channels, nullptr, plan.channels,
            static_cast<GSpacing>(plan.channels) * plan.side_px, 1, nullptr));
    }
}

// `memory_per_pixels` is the peak as a share of the full size's pixels as they are held.
void loadWholePlan(benchmark::State& state, const PlanFile& plan) {
    const auto file = planFile(plan);
    for ([[maybe_unused]] auto _ : state) {
        forgetPeak();
        const double before_bytes = memory_bytes();
        const auto loaded = loadPlan(file);
        const double peak_bytes = peakMemory_bytes() - before_bytes;
        if (!loaded) return state.SkipWithError(loaded.error().detail.c_str());
        const PlanLevel& full = loaded->levels.front();
        state.counters["memory_MB"] = peak_bytes / 1e6;
        state.counters["memory_per_pixels"] =
            peak_bytes / (static_cast<double>(full.width_px) * full.height_px * full.channels);
    }
}

// The time until something can be drawn that fills a screen.
void firstView(benchmark::State& state, const PlanFile& plan) {
    using Clock = std::chrono::steady_clock;
    const auto file = planFile(plan);
    for ([[maybe_unused]] auto _ : state) {
        forgetPeak();
        const double before_bytes = memory_bytes();
        const std::clock_t cpu_start = std::clock();
        const auto start = Clock::now();
        std::optional<Clock::duration> took;
        const auto seen = [&] {
            if (took) return;
            took = Clock::now() - start;
            state.counters["cpu_ms"] =
                1e3 * static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
            state.counters["memory_MB"] = (peakMemory_bytes() - before_bytes) / 1e6;
        };
        // What comes after the preview is not measured here.
        const auto loaded = loadPlan(
            file, [&](double) { return !took; }, [&](const PlanImage&) { seen(); });
        seen();
        state.SetIterationTime(std::chrono::duration<double>(*took).count());
    }
}

struct Ended {
    bool well = false;
    double first_view_s = 0.0;
    double peak_memory_bytes = 0.0;
};

// The system's own figure for a child that has ended would be at least what we have ourselves.
Ended openAlone(const std::string& file) {
    const std::string command = std::string(HEDR_FIRST_VIEW) + " '" + file + "'";
    FILE* const child = popen(command.c_str(), "r");
    if (!child) return {};
    Ended ended;
    const int read = std::fscanf(child, "%lf %lf", &ended.first_view_s, &ended.peak_memory_bytes);
    ended.well = pclose(child) == 0 && read == 2;
    return ended;
}

struct Budget {
    double first_view_s;
    double peak_memory_bytes;
};
constexpr Budget kGigabyte{0.3, 300e6};

// In a process that does nothing else; the peak is all of its memory, libraries too.
void firstViewAlone(benchmark::State& state, const PlanFile& plan, const Budget& budget) {
    const std::string file = planFile(plan).string();
    double most_s = 0.0;
    double most_bytes = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        const Ended ended = openAlone(file);
        if (!ended.well) return state.SkipWithError("the plan was not drawn");
        state.SetIterationTime(ended.first_view_s);
        most_s = std::max(most_s, ended.first_view_s);
        most_bytes = std::max(most_bytes, ended.peak_memory_bytes);
    }
    state.counters["worst_ms"] = 1e3 * most_s;
    state.counters["memory_MB"] = most_bytes / 1e6;
    const bool kept = most_s <= budget.first_view_s && most_bytes <= budget.peak_memory_bytes;
    const std::string figures = "over its budget: " + std::to_string(most_s) + " s, " +
                                std::to_string(most_bytes / 1e6) + " MB";
    if (!kept) state.SkipWithError(figures.c_str());
}

#define HEDR_DECODE(name, plan)                                                   \
    BENCHMARK_CAPTURE(decodeByQImage, name, plan)->Unit(benchmark::kMillisecond); \
    BENCHMARK_CAPTURE(decodeByOpenCv, name, plan)->Unit(benchmark::kMillisecond); \
    BENCHMARK_CAPTURE(decodeByGdal, name, plan)->Unit(benchmark::kMillisecond);   \
    BENCHMARK_CAPTURE(loadWholePlan, name, plan)->Unit(benchmark::kMillisecond)

HEDR_DECODE(grey_png, kGreyPng);
HEDR_DECODE(colour_png, kColourPng);
HEDR_DECODE(jpeg, kJpeg);
BENCHMARK_CAPTURE(firstView, jpeg, kJpeg)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(firstView, tiled_tiff, kTiledTiff)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(firstViewAlone, gigabyte_tiff, kGigabyteTiff, kGigabyte)
    ->UseManualTime()
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedr
