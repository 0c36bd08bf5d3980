// Tiles of a web map whose pictures are broken. GDAL leaves them white and goes on.
#include <gtest/gtest.h>

#include "core/site/plan.h"
#include "tests/core/site/made_images.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

const std::string kStartOfPng = "\x89PNG\r\n";

// An MBTiles of several grey tiles, of which as many as told are broken.
std::filesystem::path greyTiles(const ScratchFolder& folder, int broken) {
    const auto file = folder.path() / "map.mbtiles";
    const auto grey = std::make_shared<std::vector<std::uint8_t>>(900 * 600 * 4, std::uint8_t{128});
    makeImage(file, {900, 600, 4, grey},
              {.driver = "MBTiles",
               .affine = {{1113194, 0.2986, 0, 8399737, 0, -0.2986}},
               .system = "EPSG:3857"});
    std::string bytes = bytesOf(file);
    std::size_t at = bytes.find(kStartOfPng);
    for (; broken > 0 && at != std::string::npos; --broken, at = bytes.find(kStartOfPng, at)) {
        bytes.replace(at, kStartOfPng.size(), kStartOfPng.size(), 'x');
    }
    writeBytes(file, bytes);
    return file;
}

TEST(DamagedTiles, WhereAllAreBrokenTheFileIsCalledDamaged) {
    const ScratchFolder folder;
    const auto file = greyTiles(folder, 1000);
    const auto plan = loadPlan(file);
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().code, ErrorCode::kNotAnImage);
    EXPECT_EQ(plan.error().subject, file.string());
    EXPECT_TRUE(plan.error().detail.starts_with("damaged: nothing that is on it could be read"))
        << plan.error().detail;
}

TEST(DamagedTiles, WhereSomeAreBrokenTheOthersAreShown) {
    const ScratchFolder folder;
    const auto plan = loadPlan(greyTiles(folder, 1));
    EXPECT_TRUE(plan) << plan.error().detail;
}

}  // namespace
}  // namespace hedr
