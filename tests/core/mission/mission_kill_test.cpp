#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <random>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

constexpr double kRowPeriod_s = 0.01;

// Records rows that carry their own number, 100 a mission second but as fast as it goes, and
// tells the parent the time of each. Ends only by being killed.
[[noreturn]] void recordUntilKilled(const std::filesystem::path& file, int pipe) {
    auto mission = MissionWriter::create(file, {});
    if (!mission) _exit(1);
    for (std::uint64_t i = 0;; ++i) {
        const double t = kRowPeriod_s * static_cast<double>(i);
        std::vector<std::uint8_t> bytes(64);
        std::memcpy(bytes.data(), &i, sizeof i);
        const std::vector<TrackPoint> point = {{t, {{t, -t}, t}, 0.0}};
        if (!mission->writeBytes(t, bytes)) _exit(2);
        if (!mission->writeEstimates("hedr", point)) _exit(3);
        if (!mission->commitIfDue(t)) _exit(4);
        if (write(pipe, &t, sizeof t) != sizeof t) _exit(5);
    }
}

// The time of the last row that the child reports before it is killed after `reports` rows more.
double killAfter(int reports, const std::filesystem::path& file) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) recordUntilKilled(file, ends[1]);
    close(ends[1]);
    double last_s = 0.0;
    for (int i = 0; i < reports; ++i)
        EXPECT_EQ(read(ends[0], &last_s, sizeof last_s), static_cast<ssize_t>(sizeof last_s));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "the recording ended by itself: " << WEXITSTATUS(status);
    while (read(ends[0], &last_s, sizeof last_s) == static_cast<ssize_t>(sizeof last_s)) {
    }
    close(ends[0]);
    return last_s;
}

void expectLossWithinASecond(const std::filesystem::path& file, double last_s) {
    const auto mission = MissionReader::open(file);
    ASSERT_TRUE(mission) << mission.error().detail;
    std::uint64_t expected = 0;
    double stored_s = 0.0;
    ASSERT_TRUE(mission->forEachStreamRow([&](const StreamRow& row) {
        std::uint64_t number = 0;
        std::memcpy(&number, row.data.data(), sizeof number);
        EXPECT_EQ(number, expected++);
        stored_s = row.receive_time_s;
        return true;
    }));
    EXPECT_LE(last_s - stored_s, 1.0);
    EXPECT_EQ(mission->estimates("hedr")->size(), expected);
}

TEST(MissionKill, CostsAtMostASecondAndNoRepair) {
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        const ScratchFolder folder;
        const auto file = folder.path() / "drive.hedr";
        const double last_s = killAfter(std::uniform_int_distribution(1, 5000)(random), file);
        expectLossWithinASecond(file, last_s);
    }
}

TEST(MissionKill, LetsTheMissionGoOn) {
    const ScratchFolder folder;
    const auto file = folder.path() / "drive.hedr";
    killAfter(300, file);
    const auto before = MissionReader::open(file)->info();
    ASSERT_TRUE(before);
    {
        auto mission = MissionWriter::create(file, {});
        ASSERT_TRUE(mission) << mission.error().detail;
        ASSERT_TRUE(mission->writeBytes(0.25, std::vector<std::uint8_t>{1}));
    }
    const auto after = MissionReader::open(file)->info();
    ASSERT_TRUE(after);
    EXPECT_EQ(after->stream_rows, before->stream_rows + 1);
    EXPECT_EQ(after->duration_s, before->duration_s + 0.25);
}

}  // namespace
}  // namespace hedr
