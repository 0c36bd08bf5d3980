#include "core/site/image_hash.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;
using Why = ChangedImage::Why;

class ImageHash : public testing::Test {
  protected:
    fs::path written(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
        return folder_.path() / name;
    }

    ScratchFolder folder_;
};

TEST_F(ImageHash, IsThatOfTheStandard) {  // FIPS 180-2, appendix B
    EXPECT_EQ(imageHash(written("abc", "abc")).value(),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(imageHash(written("a", std::string(1000000, 'a'))).value(),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    EXPECT_EQ(imageHash(written("empty", "")).value(),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(ImageHash, TellsHowFarItIsAndCanBeCanceled) {
    const fs::path file = written("big", std::string((std::size_t{5} << 20) + 1, 'x'));
    std::vector<double> told;
    ASSERT_TRUE(imageHash(file, [&](double share) {
        told.push_back(share);
        return true;
    }));
    ASSERT_EQ(told.size(), 6U);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0);
    EXPECT_EQ(imageHash(file, [](double share) { return share < 0.5; }).error().code,
              ErrorCode::kCanceled);
}

TEST_F(ImageHash, NeedsAFileThatEnds) {
    EXPECT_EQ(imageHash(folder_.path() / "none").error().code, ErrorCode::kFileMissing);
    EXPECT_EQ(imageHash(folder_.path()).error().code, ErrorCode::kFileUnreadable);
    EXPECT_EQ(imageHash("/dev/zero").error().code, ErrorCode::kFileUnreadable);
}

TEST_F(ImageHash, TellsWhichImagesOfASiteAreNotAsTheyWere) {
    const fs::path same = written("same", "abc");
    const fs::path other = written("other", "now");
    const std::string hash = imageHash(same).value();
    const fs::path gone = folder_.path() / "gone";
    const Site site{
        .floors = {
            {.name = "0", .plans = {{.image_file = same, .sha256 = hash}, {.image_file = other}}},
            {.name = "1",
             .plans = {{.image_file = gone},
                       {.image_file = other, .sha256 = hash},
                       {.image_file = folder_.path(), .sha256 = hash}}}}};
    const auto changed = changedImages(site, [](const fs::path& f) { return imageHash(f); });
    EXPECT_EQ(changed, (std::vector<ChangedImage>{{1, 0, gone, Why::kMissing},
                                                  {1, 1, other, Why::kOtherContent},
                                                  {1, 2, folder_.path(), Why::kUnreadable}}));
}

TEST_F(ImageHash, IsAskedOncePerFileAndNotBelievedWhereItWasCanceled) {
    const Site site{.floors = {{.name = "0",
                                .plans = {{.image_file = "a", .sha256 = "1"},
                                          {.image_file = "a", .sha256 = "1"}}}}};
    int asked = 0;
    const auto changed = changedImages(site, [&](const fs::path& file) -> Result<std::string> {
        ++asked;
        return fail(ErrorCode::kCanceled, file.string());
    });
    EXPECT_TRUE(changed.empty());
    EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace hedr
