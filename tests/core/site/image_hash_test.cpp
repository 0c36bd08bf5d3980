#include "core/site/image_hash.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/text/file_hash.h"
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

TEST_F(ImageHash, TellsWhichImagesOfASiteAreNotAsTheyWere) {
    const fs::path same = written("same", "abc");
    const fs::path other = written("other", "now");
    const std::string hash = fileHash(same).value();
    const fs::path gone = folder_.path() / "gone";
    const Site site{
        .floors = {
            {.name = "0", .plans = {{.image_file = same, .sha256 = hash}, {.image_file = other}}},
            {.name = "1",
             .plans = {{.image_file = gone},
                       {.image_file = other, .sha256 = hash},
                       {.image_file = folder_.path(), .sha256 = hash}}}}};
    const auto changed = changedImages(site, [](const fs::path& f) { return fileHash(f); });
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
