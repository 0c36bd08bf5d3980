#include "core/text/file_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

class FileHash : public testing::Test {
  protected:
    fs::path written(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
        return folder_.path() / name;
    }

    ScratchFolder folder_;
};

TEST_F(FileHash, IsThatOfTheStandard) {  // FIPS 180-2, appendix B
    EXPECT_EQ(fileHash(written("abc", "abc")).value(),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(fileHash(written("a", std::string(1000000, 'a'))).value(),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    EXPECT_EQ(fileHash(written("empty", "")).value(),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(FileHash, TellsHowFarItIsAndCanBeCanceled) {
    const fs::path file = written("big", std::string((std::size_t{5} << 20) + 1, 'x'));
    std::vector<double> told;
    ASSERT_TRUE(fileHash(file, [&](double share) {
        told.push_back(share);
        return true;
    }));
    ASSERT_EQ(told.size(), 6U);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0);
    EXPECT_EQ(fileHash(file, [](double share) { return share < 0.5; }).error().code,
              ErrorCode::kCanceled);
}

TEST_F(FileHash, NeedsAFileThatEnds) {
    EXPECT_EQ(fileHash(folder_.path() / "none").error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(fileHash(folder_.path()).error().code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(fileHash("/dev/zero").error().code, ErrorCode::kFileUnreadable);
}

}  // namespace
}  // namespace hedr
