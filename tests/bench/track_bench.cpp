#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "core/track/track.h"

namespace hedr {
namespace {

// A random walk of 5 mm steps, as in the measurements of other programs.
Track randomWalk(std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> turn(-0.2, 0.2);
    Track track;
    Pose<World> pose;
    for (std::size_t i = 0; i < count; ++i) {
        pose.heading_rad += turn(random);
        pose.position = pose.position + 0.005 * Vector<World>{std::cos(pose.heading_rad),
                                                              std::sin(pose.heading_rad)};
        track.append({0.01 * static_cast<double>(i), pose, 0.0});
    }
    return track;
}

void appendPoints(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    std::size_t bytes = 0;
    for (auto _ : state) bytes = randomWalk(count).memoryBytes();
    state.SetItemsProcessed(state.iterations() * state.range(0));
    state.counters["bytes_per_point"] = static_cast<double>(bytes) / static_cast<double>(count);
}

// The whole track into 1920 pixels, or a part of it around the middle of the drive.
void simplifyTrack(benchmark::State& state) {
    const Track track = randomWalk(static_cast<std::size_t>(state.range(0)));
    const Vector<World> extent = track.bounds().max - track.bounds().min;
    const Vector<World> half = (0.5 / static_cast<double>(state.range(1))) * extent;
    const Point<World> middle = track.at(track.size() / 2).pose.position;
    const WorldBox area =
        state.range(1) == 1 ? track.bounds() : WorldBox{middle + (-1.0) * half, middle + half};
    const double tolerance_m = half.x / 1920.0;  // half a pixel
    std::size_t points = 0;
    for (auto _ : state) {
        points = 0;
        track.simplified(area, tolerance_m, [&points](auto run) { points += run.size(); });
    }
    state.counters["drawn_points"] = static_cast<double>(points);
}

void copyTrack(benchmark::State& state) {
    const Track track = randomWalk(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(Track(track));
}

BENCHMARK(appendPoints)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(simplifyTrack)
    ->ArgNames({"points", "zoom"})
    ->ArgsProduct({{100'000, 1'000'000, 10'000'000}, {1, 10, 100}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(copyTrack)->Arg(1'000'000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hedr
