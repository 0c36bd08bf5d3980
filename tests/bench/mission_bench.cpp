#include <benchmark/benchmark.h>

#include <filesystem>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"

namespace hedr {
namespace {

std::filesystem::path scratchFile() {
    return std::filesystem::temp_directory_path() / "hedr_bench.hedr";
}

// Rows of 40 bytes at 100 Hz with one estimator, committed as while recording.
Result<void> record(std::int64_t rows) {
    auto mission = MissionWriter::create(scratchFile(), {});
    if (!mission) return tl::make_unexpected(mission.error());
    const std::vector<std::uint8_t> bytes(40, 7);
    Result<void> done;
    for (std::int64_t i = 0; done && i < rows; ++i) {
        const double t = 0.01 * static_cast<double>(i);
        const TrackPoint point = {t, {{t, t}, t}, 0.0};
        done = mission->writeBytes(t, bytes);
        if (done) done = mission->writeEstimates("hedr", {&point, 1});
        if (done) done = mission->commitIfDue(t);
    }
    return done;
}

void removeMission() {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(scratchFile() += end);
}

void recordMission(benchmark::State& state) {
    for (auto _ : state) {
        removeMission();
        if (!record(state.range(0))) return state.SkipWithError("no room for the file");
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
    removeMission();
}

void readMission(benchmark::State& state) {
    removeMission();
    if (!record(state.range(0))) return state.SkipWithError("no room for the file");
    for (auto _ : state) {
        const auto mission = MissionReader::open(scratchFile());
        std::size_t bytes = 0;
        (void)mission->forEachStreamRow(
            [&bytes](const StreamRow& row) { return (bytes += row.data.size()) > 0; });
        benchmark::DoNotOptimize(bytes);
        benchmark::DoNotOptimize(mission->estimates("hedr"));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
    removeMission();
}

// From the file to what the operator is told of it: independent of the mission's length.
void openMission(benchmark::State& state) {
    removeMission();
    if (!record(state.range(0))) return state.SkipWithError("no room for the file");
    for (auto _ : state) benchmark::DoNotOptimize(MissionReader::open(scratchFile())->info());
    removeMission();
}

BENCHMARK(recordMission)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(readMission)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(openMission)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedr
