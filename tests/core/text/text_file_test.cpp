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

}  // namespace
}  // namespace hedr
