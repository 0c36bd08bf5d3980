// A working day of a robot at 100 Hz, accelerated: what it costs on disk and in memory.
#include <gtest/gtest.h>

#include <string>

#include "core/mission/mission_reader.h"
#include "radio/recomputation.h"
#include "radio/recorder.h"
#include "tests/core/text/scratch_folder.h"
#include "tests/radio/long_drive.h"
#include "tests/radio/resident_memory.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {
namespace {

struct Cost {
    double file_megabytes = 0.0;
    double grown_megabytes = 0.0;  // of memory, trails left out: nobody keeps them here
};

// What LiveLink does on the radio thread, without its clocks.
Cost record(const std::filesystem::path& file, double hours) {
    Receiver receiver({});
    Recorder recorder(file, {.start = std::chrono::system_clock::now(), .program_version = "test"});
    SimulatedRobot robot(spokenVehicle(), {});
    LongDrive drive;
    double before_megabytes = 0.0;
    const auto reports = static_cast<std::int64_t>(hours * 360'000.0);
    for (std::int64_t i = 0; i < reports; ++i) {
        const double now_s = 0.01 * static_cast<double>(i);
        robot.sense(drive.next(), [&](std::span<const std::uint8_t> frame) {
            recorder.addBytes(now_s, frame);
            receiver.feed(frame);
        });
        if (i % 2 == 0) recorder.addEstimates(receiver.takePoints());
        if (i % 100 == 0) recorder.addLinkSample({.receive_time_s = now_s, .round_trip_s = 0.04});
        recorder.writeIfDue(now_s);
        if (i == reports / 4) before_megabytes = residentMegabytes();
    }
    recorder.addEstimates(receiver.takePoints());
    recorder.write();
    EXPECT_FALSE(recorder.state().error);
    return {static_cast<double>(std::filesystem::file_size(file)) / 1e6,
            residentMegabytes() - before_megabytes};
}

TEST(EightHours, AQuarterOfAnHourCostsItsShare) {
    const ScratchFolder folder;
    const Cost cost = record(folder.path() / "m.hedr", 0.25);
    EXPECT_LE(cost.file_megabytes, 150.0 * 0.25 / 8.0 + 1.0);
    EXPECT_TRUE(recomputeTrack(folder.path() / "m.hedr", "hedr", {}).value().as_live);
}

TEST(EightHours, DISABLED_FitInto150MegabytesAndNoMoreMemory) {
    const ScratchFolder folder;
    const Cost cost = record(folder.path() / "m.hedr", 8.0);
    RecordProperty("file_megabytes", std::to_string(cost.file_megabytes));
    RecordProperty("grown_megabytes", std::to_string(cost.grown_megabytes));
    EXPECT_LE(cost.file_megabytes, 150.0);
    EXPECT_LE(cost.grown_megabytes, 10.0);
    EXPECT_TRUE(recomputeTrack(folder.path() / "m.hedr", "hedr", {}).value().as_live);
}

}  // namespace
}  // namespace hedr
