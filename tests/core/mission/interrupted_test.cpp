#include "core/mission/interrupted.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_writer.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// A mission whose recorder was killed.
void recordAndDie(const fs::path& file) {
    const pid_t child = ::fork();
    if (child == 0) {
        auto writer = MissionWriter::create(
            file, {.start = std::chrono::system_clock::now(), .program_version = "test"});
        const std::uint8_t bytes[] = {1, 2, 3};
        if (writer) {
            (void)writer->writeBytes(12.0, bytes);
            (void)writer->commit();
        }
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
}

TEST(InterruptedMission, IsTheNewestThatNobodyHasClosed) {
    const ScratchFolder folder;
    EXPECT_FALSE(findInterrupted(folder.path() / "nothing"));
    EXPECT_FALSE(findInterrupted(folder.path()));
    recordAndDie(folder.path() / "a.hedr");
    const auto found = findInterrupted(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->file, folder.path() / "a.hedr");
    EXPECT_EQ(found->info.duration_s, 12.0);
    EXPECT_TRUE(findInterrupted(folder.path())) << "to look changes nothing";
}

TEST(InterruptedMission, IsNoneThatIsBeingRecorded) {
    const ScratchFolder folder;
    recordAndDie(folder.path() / "a.hedr");
    const auto recorder = MissionWriter::create(folder.path() / "a.hedr", {});
    ASSERT_TRUE(recorder);
    EXPECT_FALSE(findInterrupted(folder.path()));
}

TEST(InterruptedMission, IsOfferedOnceAndLosesNothingWhenItIsLeft) {
    const ScratchFolder folder;
    const fs::path file = folder.path() / "a.hedr";
    recordAndDie(file);
    ASSERT_TRUE(closeInterrupted(file));
    EXPECT_FALSE(findInterrupted(folder.path()));
    const auto reader = MissionReader::open(file);
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->info()->duration_s, 12.0);
    EXPECT_EQ(reader->info()->stream_rows, 1U);
}

}  // namespace
}  // namespace hedr
