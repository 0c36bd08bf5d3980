#include "core/site/raster/canvas.h"

#include <utility>

#include "core/site/raster/blank_pixels.h"

namespace hedr {
namespace {

constexpr int kLongestSide_px = 32767;  // cairo's

}  // namespace

Result<Canvas> Canvas::create(int width_px, int height_px, const std::string& path) {
    if (width_px > kLongestSide_px || height_px > kLongestSide_px) {
        return fail(ErrorCode::kImageTooLarge, path,
                    std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels");
    }
    auto pixels = blankPixels(width_px, height_px, 4, path);
    if (!pixels) return tl::make_unexpected(pixels.error());
    Canvas canvas;
    canvas.pixels_ = std::move(*pixels);
    canvas.level_ = {width_px, height_px, 4};
    // Its 32-bit words are B, G, R, A in memory on the machines that we run on.
    canvas.surface_.reset(cairo_image_surface_create_for_data(
        canvas.pixels_->data(), CAIRO_FORMAT_ARGB32, width_px, height_px, 4 * width_px));
    canvas.cairo_.reset(cairo_create(canvas.surface_.get()));
    return canvas;
}

void Canvas::finish() {
    cairo_.reset();
    cairo_surface_flush(surface_.get());
    surface_.reset();
}

PlanLevel Canvas::colour() && {
    finish();
    level_.pixels = std::move(pixels_);
    return level_;
}

PlanLevel Canvas::grey() && {
    finish();
    std::vector<std::uint8_t>& bytes = *pixels_;
    for (std::size_t i = 0; i < bytes.size() / 4; ++i) bytes[i] = bytes[4 * i];
    bytes.resize(bytes.size() / 4);
    bytes.shrink_to_fit();
    level_.channels = 1;
    level_.pixels = std::move(pixels_);
    return level_;
}

}  // namespace hedr
