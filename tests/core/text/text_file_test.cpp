#include "core/text/text_file.h"

#include <gtest/gtest.h>

#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

TEST(WriteTextFile, ReplacesAFileAndLeavesNoDraft) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeTextFile(folder.path() / "a.csv", "old"));
    ASSERT_TRUE(writeTextFile(folder.path() / "a.csv", "new"));
    EXPECT_EQ(readTextFile(folder.path() / "a.csv").value(), "new");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.csv.part"));
}

TEST(WriteTextFile, TakesNoDraftNameThatIsSomebodysFile) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeTextFile(folder.path() / "a.csv.part", "a recording"));
    ASSERT_TRUE(writeTextFile(folder.path() / "a.csv", "a track"));
    EXPECT_EQ(readTextFile(folder.path() / "a.csv.part").value(), "a recording");
    EXPECT_EQ(readTextFile(folder.path() / "a.csv").value(), "a track");
}

TEST(WriteTextFile, LeavesAFilesModeAsItWas) {
    constexpr auto kOwnersOnly =
        std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
    const ScratchFolder folder;
    const auto file = folder.path() / "a.toml";
    ASSERT_TRUE(writeTextFile(file, "old"));
    std::filesystem::permissions(file, kOwnersOnly);
    ASSERT_TRUE(writeTextFile(file, "new"));
    EXPECT_EQ(std::filesystem::status(file).permissions(), kOwnersOnly);
}

TEST(ReadTextFile, GivesUpOnAStreamWithoutAnEnd) {
    const auto text = readTextFile("/dev/zero");
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().code, ErrorCode::kFileTooLarge);
}

// A sparse file takes no room on the disk.
TEST(ReadTextFile, SaysThatAFileDoesNotFitIntoMemory) {
    const ScratchFolder folder;
    const auto file = folder.path() / "huge.csv";
    ASSERT_TRUE(writeTextFile(file, "t_s\n"));
    std::error_code error;
    std::filesystem::resize_file(file, std::uintmax_t{1} << 43, error);
    if (error) GTEST_SKIP() << "this file system has no files of 8 TB";
    const auto text = readTextFile(file);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().code, ErrorCode::kFileTooLarge);
}

}  // namespace
}  // namespace hedr
