#include "core/site/raster/blank_pixels.h"

#include <unistd.h>

#include <cmath>
#include <new>

namespace hedr {
namespace {

constexpr double kMostPixels = 1.2e9;
constexpr double kPyramidShare = 4.0 / 3.0;  // of all levels, to the full size
constexpr double kMostOfMemory = 0.8;

bool fits(double pixels, int channels) {
    const double bytes = kPyramidShare * pixels * channels;
    const double memory =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    return pixels <= kMostPixels && (memory <= 0.0 || bytes <= kMostOfMemory * memory);
}

}  // namespace

Result<std::shared_ptr<std::vector<std::uint8_t>>> blankPixels(double width_px, double height_px,
                                                               int channels,
                                                               const std::string& path) {
    const auto too_large = [&] {
        return fail(ErrorCode::kImageTooLarge, path,
                    std::to_string(std::llround(width_px)) + " x " +
                        std::to_string(std::llround(height_px)) + " pixels");
    };
    if (!fits(width_px * height_px, channels)) return too_large();
    try {
        return std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(width_px) *
                                                               static_cast<std::size_t>(height_px) *
                                                               static_cast<std::size_t>(channels),
                                                           std::uint8_t{255});
    } catch (const std::bad_alloc&) {
        return too_large();
    }
}

}  // namespace hedr
