#include "core/site/raster/svg_drawing.h"

#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/site/mip_pyramid.h"
#include "core/site/raster/canvas.h"

namespace hedr {
namespace {

constexpr double kInch_mm = 25.4;
constexpr double kUnitsPerInch = 96.0;

struct Unref {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(GFile* file) const { g_object_unref(file); }
    void operator()(GError* error) const { g_error_free(error); }
};
using Drawing = std::unique_ptr<RsvgHandle, Unref>;

tl::unexpected<Error> svgError(const std::filesystem::path& file, GError* error) {
    const std::unique_ptr<GError, Unref> owned(error);
    return fail(ErrorCode::kNotAnImage, file.string(),
                std::string("damaged SVG: ") + (owned ? owned->message : "it cannot be drawn"));
}

// Images that it names are read where they lie beside it, and from nowhere else.
Result<Drawing> open(const std::filesystem::path& file) {
    const std::unique_ptr<GFile, Unref> source(g_file_new_for_path(file.c_str()));
    GError* error = nullptr;
    Drawing drawing(
        rsvg_handle_new_from_gfile_sync(source.get(), RSVG_HANDLE_FLAGS_NONE, nullptr, &error));
    if (!drawing) return svgError(file, error);
    rsvg_handle_set_dpi(drawing.get(), kUnitsPerInch);
    return drawing;
}

// In units of 1/96 inch: its own size, else that of what is drawn. Error: kNotAnImage.
Result<RsvgRectangle> sizeOf(RsvgHandle& drawing, const std::filesystem::path& file) {
    RsvgRectangle size{0.0, 0.0, 0.0, 0.0};
    if (!rsvg_handle_get_intrinsic_size_in_pixels(&drawing, &size.width, &size.height)) {
        gboolean has_box = FALSE;
        RsvgRectangle box{};
        rsvg_handle_get_intrinsic_dimensions(&drawing, nullptr, nullptr, nullptr, nullptr, &has_box,
                                             &box);
        if (!has_box) {
            rsvg_handle_get_geometry_for_element(&drawing, nullptr, &box, nullptr, nullptr);
        }
        size = {0.0, 0.0, box.width, box.height};
    }
    if (std::isfinite(size.width) && std::isfinite(size.height) && size.width > 0.0 &&
        size.height > 0.0) {
        return size;
    }
    return fail(ErrorCode::kNotAnImage, file.string(), "the SVG has no size");
}

PlanPage pageOf(const RsvgRectangle& size, const PictureJob& job) {
    PlanPage page;
    page.paper_width_mm = size.width / kUnitsPerInch * kInch_mm;
    page.paper_height_mm = size.height / kUnitsPerInch * kInch_mm;
    const double dpi = dpiOf(job, std::max(page.paper_width_mm, page.paper_height_mm));
    const auto pixels = [&](double mm) {
        return static_cast<int>(std::clamp(std::ceil(mm / kInch_mm * dpi), 1.0, 1e9));
    };
    page.width_px = pixels(page.paper_width_mm);
    page.height_px = pixels(page.paper_height_mm);
    return page;
}

}  // namespace

Result<Picture> loadSvg(const std::filesystem::path& file, const PictureJob& job) {
    const auto drawing = open(file);
    if (!drawing) return tl::make_unexpected(drawing.error());
    const auto size = sizeOf(**drawing, file);
    if (!size) return tl::make_unexpected(size.error());
    const PlanPage page = pageOf(*size, job);
    auto canvas = Canvas::create(page.width_px, page.height_px, file.string());
    if (!canvas) return tl::make_unexpected(canvas.error());
    if (wasCanceled(job, 0.1)) return fail(ErrorCode::kCanceled, file.string());
    const double dpi = dpiOf(job, std::max(page.paper_width_mm, page.paper_height_mm));
    const double scale = dpi / kUnitsPerInch;
    const RsvgRectangle viewport{0.0, 0.0, scale * size->width, scale * size->height};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(drawing->get(), canvas->cairo(), &viewport, &error)) {
        return svgError(file, error);
    }
    if (wasCanceled(job, 0.9)) return fail(ErrorCode::kCanceled, file.string());
    Picture picture{mipPyramid(std::move(*canvas).colour())};
    picture.placement = PlanPlacement{.resolution_m = pageResolution_m(job.choice, dpi)};
    return picture;
}

Result<PlanDescription> describeSvg(const std::filesystem::path& file, const PictureJob& job) {
    return open(file)
        .and_then([&](const Drawing& drawing) { return sizeOf(*drawing, file); })
        .map([&](const RsvgRectangle& size) {
            return PlanDescription{"SVG", {pageOf(size, job)}};
        });
}

}  // namespace hedr
