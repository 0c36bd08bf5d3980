#include "core/site/raster/packed_pixels.h"

#include <gtest/gtest.h>

namespace hedr {
namespace {

std::uint8_t colourAt(std::size_t pixel, std::size_t channel) {
    return static_cast<std::uint8_t>(pixel / (1 + 250 * channel) + 7 * channel);
}

// It is done in place, a quarter after the other: of no size may a pixel be written over before it
// is read.
TEST(PackedPixels, BecomeBgraInTheirPlaceWhateverTheirNumber) {
    for (const std::size_t count : {0, 1, 2, 16383, 16384, 16385, 50'000, 262'147}) {
        std::vector<std::uint8_t> pixels(4 * count);
        std::vector<std::uint8_t> wanted;
        for (std::size_t i = 0; i < count; ++i) {
            for (const std::size_t c : {0, 1, 2}) pixels[3 * i + c] = colourAt(i, c);
            for (const std::size_t c : {2, 1, 0}) wanted.push_back(colourAt(i, c));
            wanted.push_back(255);
        }
        unpack(pixels, Packing::kRgb);
        EXPECT_TRUE(pixels == wanted) << count;
    }
}

}  // namespace
}  // namespace hedr
