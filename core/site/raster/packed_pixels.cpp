#include "core/site/raster/packed_pixels.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

namespace hedr {
namespace {

constexpr std::size_t kAtOnce = 4096;  // pixels, so that they stay in the fastest cache

// Backwards, so that nothing is overwritten before it has been read.
void unpackRgb(std::vector<std::uint8_t>& pixels) {
    std::array<std::uint8_t, 3 * kAtOnce> packed{};
    for (std::size_t end = pixels.size() / 4; end > 0;) {
        const std::size_t count = std::min(end, kAtOnce);
        end -= count;
        std::copy_n(&pixels[3 * end], 3 * count, packed.data());
        const auto columns = static_cast<int>(count);
        const cv::Mat from(1, columns, CV_8UC3, packed.data());
        cv::Mat to(1, columns, CV_8UC4, &pixels[4 * end]);
        cv::cvtColor(from, to, cv::COLOR_RGB2BGRA);
    }
}

void unpackRgba(std::vector<std::uint8_t>& pixels) {
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        std::uint8_t* p = &pixels[i];
        std::swap(p[0], p[2]);
        if (p[3] == 255) continue;
        for (std::size_t c = 0; c < 3; ++c) p[c] = onWhite(p[c], p[3]);
        p[3] = 255;
    }
}

void unpackCmyk(std::vector<std::uint8_t>& pixels) {
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        std::uint8_t* p = &pixels[i];
        std::swap(p[0], p[2]);
        const unsigned light = 255U - p[3];
        for (std::size_t c = 0; c < 3; ++c) {
            p[c] = static_cast<std::uint8_t>(((255U - p[c]) * light + 127U) / 255U);
        }
        p[3] = 255;
    }
}

}  // namespace

std::uint8_t onWhite(unsigned value, unsigned opacity) {
    if (opacity == 255) return static_cast<std::uint8_t>(value);
    return static_cast<std::uint8_t>((value * opacity + 255U * (255U - opacity) + 127U) / 255U);
}

void unpack(std::vector<std::uint8_t>& pixels, Packing packing) {
    if (packing == Packing::kRgb) unpackRgb(pixels);
    if (packing == Packing::kRgba) unpackRgba(pixels);
    if (packing == Packing::kCmyk) unpackCmyk(pixels);
}

}  // namespace hedr
