#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

#include "core/robot/sensor_csv.h"
#include "core/track/evaluation.h"
#include "core/track/track_file.h"

namespace hedr {
namespace {

std::vector<TrackPoint> longTrack(std::size_t count, double drift) {
    std::vector<TrackPoint> track;
    track.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 0.01 * static_cast<double>(i);
        const double heading = 0.05 * t + drift * t;
        track.push_back(
            {t, {{20.0 * std::sin(heading), 20.0 - 20.0 * std::cos(heading)}, heading}});
    }
    return track;
}

std::filesystem::path scratchFile(const char* name) {
    return std::filesystem::temp_directory_path() / name;
}

void evaluateTracks(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const auto truth = longTrack(count, 0.0);
    const auto estimate = longTrack(count, 1e-5);
    for (auto _ : state) benchmark::DoNotOptimize(evaluate(estimate, truth, Alignment::kRigid));
}

// From two files, as the command line does it.
void evaluateFiles(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const auto truth_file = scratchFile("hedr_bench_truth.csv");
    const auto estimate_file = scratchFile("hedr_bench_estimate.csv");
    if (!saveTrack(truth_file, longTrack(count, 0.0)) ||
        !saveTrack(estimate_file, longTrack(count, 1e-5)))
        return state.SkipWithError("no room for the files");
    for (auto _ : state)
        benchmark::DoNotOptimize(
            evaluate(*loadTrack(estimate_file), *loadTrack(truth_file), Alignment::kStart));
    std::filesystem::remove(truth_file);
    std::filesystem::remove(estimate_file);
}

void readSensorLog(benchmark::State& state) {
    std::vector<SensorReport> reports(static_cast<std::size_t>(state.range(0)));
    for (std::size_t i = 0; i < reports.size(); ++i) {
        const auto n = static_cast<std::int64_t>(i);
        reports[i].robot_time_s = 0.01 * static_cast<double>(i);
        reports[i].odometry = WheelTicks{3 * n, 4 * n};
        reports[i].gyro = GyroRate{0.1 * std::sin(0.001 * static_cast<double>(i))};
    }
    const auto file = scratchFile("hedr_bench_sensors.csv");
    if (!saveSensorLog(file, reports)) return state.SkipWithError("no room for the file");
    for (auto _ : state) benchmark::DoNotOptimize(loadSensorLog(file));
    state.SetItemsProcessed(state.iterations() * state.range(0));
    std::filesystem::remove(file);
}

BENCHMARK(evaluateTracks)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(evaluateFiles)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(readSensorLog)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedr
