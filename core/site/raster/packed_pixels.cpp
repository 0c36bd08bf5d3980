#include "core/site/raster/packed_pixels.h"

#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace hedr {
namespace {

constexpr std::size_t kColumns = 4096;  // so many pixels stay in the fastest cache

// Whole rows of pixels, on all processors.
void unpackRows(std::uint8_t* packed, std::uint8_t* pixels, std::size_t rows, std::size_t columns) {
    const cv::Size size(static_cast<int>(columns), static_cast<int>(rows));
    const cv::Mat from(size, CV_8UC3, packed);
    cv::Mat to(size, CV_8UC4, pixels);
    cv::cvtColor(from, to, cv::COLOR_RGB2BGRA);
}

// From behind, each time the last quarter, which has its place behind all that is still packed; the
// few first pixels from a copy.
void unpackRgb(std::vector<std::uint8_t>& pixels) {
    std::size_t end = pixels.size() / 4;
    for (std::size_t rows = end / 4 / kColumns; rows > 0; rows = end / 4 / kColumns) {
        end -= rows * kColumns;
        unpackRows(&pixels[3 * end], &pixels[4 * end], rows, kColumns);
    }
    std::vector<std::uint8_t> first(pixels.begin(),
                                    pixels.begin() + static_cast<std::ptrdiff_t>(3 * end));
    if (end > 0) unpackRows(first.data(), pixels.data(), 1, end);
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
