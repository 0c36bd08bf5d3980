#include "core/site/mip_pyramid.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

using Bytes = std::vector<std::uint8_t>;

PlanLevel plain(int width, int height, int channels, std::uint8_t value) {
    const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height * channels);
    return {width, height, channels, std::make_shared<const Bytes>(size, value)};
}

TEST(MipPyramid, HalvesUntilBelow512Pixels) {
    const auto levels = mipPyramid(plain(2049, 700, 1, 9));
    std::vector<std::pair<int, int>> sizes;
    for (const PlanLevel& level : levels) sizes.emplace_back(level.width_px, level.height_px);
    EXPECT_EQ(sizes,
              (std::vector<std::pair<int, int>>{{2049, 700}, {1025, 350}, {513, 175}, {257, 88}}));
}

TEST(MipPyramid, LeavesASmallImageAlone) {
    EXPECT_EQ(mipPyramid(plain(1, 1, 4, 7)).size(), 1U);
    EXPECT_EQ(mipPyramid(plain(511, 300, 1, 7)).size(), 1U);
    EXPECT_EQ(mipPyramid(plain(512, 1, 1, 7)).size(), 2U);
}

TEST(MipPyramid, KeepsAPlainImagePlainAtOddSizes) {
    for (const PlanLevel& level : mipPyramid(plain(1023, 777, 4, 42))) {
        for (const std::uint8_t value : *level.pixels) ASSERT_EQ(value, 42);
    }
}

TEST(MipPyramid, AveragesFourPixelsIntoOne) {
    Bytes bytes(1024 * 2);
    for (std::size_t x = 0; x < 1024; ++x) {
        bytes[x] = x % 2 == 0 ? 0 : 100;
        bytes[1024 + x] = x % 2 == 0 ? 100 : 200;
    }
    const auto levels = mipPyramid({1024, 2, 1, std::make_shared<const Bytes>(bytes)});
    EXPECT_EQ(*levels[1].pixels, Bytes(512, 100));
}

TEST(MipPyramid, SharesThePixelsOfTheFullSize) {
    const PlanLevel full = plain(600, 600, 1, 3);
    EXPECT_EQ(mipPyramid(full).front().pixels, full.pixels);
}

}  // namespace
}  // namespace hedr
