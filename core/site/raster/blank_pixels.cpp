#include "core/site/raster/blank_pixels.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <future>
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

// The kernel gives a page when it is first touched, and clears it: a sixth of the time that a large
// picture takes. Both halves are asked for at once. An old kernel refuses, and gives them later.
void askForPages(std::vector<std::uint8_t>& reserved) {
    constexpr std::size_t kWorthwhile = std::size_t{16} << 20;
    constexpr int kPopulateWrite = 23;  // MADV_POPULATE_WRITE, of Linux 5.14
    if (reserved.capacity() < kWorthwhile) return;
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    void* first = reserved.data();
    std::size_t room = reserved.capacity();
    if (!std::align(page, 2 * page, first, room)) return;
    const std::size_t half = room / (2 * page) * page;
    const auto ask = [half](void* from) { (void)madvise(from, half, kPopulateWrite); };
    const auto second =
        std::async(std::launch::async, ask, static_cast<std::uint8_t*>(first) + half);
    ask(first);
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
        auto pixels = std::make_shared<std::vector<std::uint8_t>>();
        const auto bytes = static_cast<std::size_t>(width_px) *
                           static_cast<std::size_t>(height_px) * static_cast<std::size_t>(channels);
        pixels->reserve(bytes);
        askForPages(*pixels);
        pixels->resize(bytes, 255);
        return pixels;
    } catch (const std::bad_alloc&) {
        return too_large();
    }
}

}  // namespace hedr
