#include "core/site/raster/dxf_drawing.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/site/mip_pyramid.h"
#include "core/site/raster/canvas.h"
#include "core/site/raster/gdal_file.h"
#include "core/text/number.h"
#include "core/text/trimmed.h"

namespace hedr {
namespace {

constexpr double kLongestSide_px = 4000.0;
constexpr double kFinest_m = 0.002;  // per pixel: a small drawing is not blown up
constexpr double kMargin_px = 8.0;
constexpr double kLine_px = 1.5;
constexpr double kLargestSite = 1000.0;  // a larger drawing without a unit is in millimetres
constexpr double kLocal_m = 100e3;       // farther away is a country's grid, not a site's
constexpr int kMostHeaderLines = 20'000;

// Metres of the units that $INSUNITS numbers; nothing for those that no building is drawn in.
std::optional<double> unitOf(std::int64_t insunits) {
    constexpr std::array<double, 7> kUnits_m = {0.0, 0.0254, 0.3048, 1609.344, 0.001, 0.01, 1.0};
    if (insunits < 1 || insunits >= static_cast<std::int64_t>(kUnits_m.size())) return {};
    return kUnits_m[static_cast<std::size_t>(insunits)];
}

// The header is pairs of lines, a code and a value: 9 $INSUNITS, then 70 and the number.
std::optional<double> unitOfHeader(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    for (int i = 0; i < kMostHeaderLines && std::getline(in, line); ++i) {
        if (trimmed(line) == "ENTITIES") return std::nullopt;
        if (trimmed(line) != "$INSUNITS") continue;
        std::getline(in, line);
        std::getline(in, line);
        const auto number = parseInteger(trimmed(line));
        return number ? unitOf(*number) : std::nullopt;
    }
    return std::nullopt;
}

struct Drawing {
    Dataset dataset;
    OGREnvelope extent;  // in its own unit
    double unit_m = 1.0;
    double resolution_m = 0.0;
    PlanPage page{};
};

bool isDrawn(const OGRGeometry& geometry) {
    return wkbFlatten(geometry.getGeometryType()) != wkbPoint;  // those are texts
}

// Calls `use` with every line, outline and hatching until it returns false.
template <class Use>
bool forEachGeometry(GDALDataset& dataset, Use use) {
    for (OGRLayer* layer : dataset.GetLayers()) {
        for (const auto& feature : layer) {
            const OGRGeometry* geometry = feature->GetGeometryRef();
            if (!geometry || geometry->IsEmpty() || !isDrawn(*geometry)) continue;
            if (!use(*geometry)) return false;
        }
    }
    return true;
}

OGREnvelope extentOf(GDALDataset& dataset) {
    OGREnvelope all;
    forEachGeometry(dataset, [&](const OGRGeometry& geometry) {
        OGREnvelope one;
        geometry.getEnvelope(&one);
        all.Merge(one);
        return true;
    });
    return all;
}

void chooseSize(Drawing& drawing, const PictureJob& job) {
    const OGREnvelope& e = drawing.extent;
    const double width_m = drawing.unit_m * (e.MaxX - e.MinX);
    const double height_m = drawing.unit_m * (e.MaxY - e.MinY);
    const double side_px = job.longest_side_px > 0 ? job.longest_side_px : kLongestSide_px;
    const double room_px = std::max(1.0, side_px - 2.0 * kMargin_px);
    drawing.resolution_m = std::max(kFinest_m, std::max(width_m, height_m) / room_px);
    const auto pixels = [&](double length_m) {
        return static_cast<int>(std::ceil(length_m / drawing.resolution_m + 2.0 * kMargin_px));
    };
    drawing.page.width_px = pixels(width_m);
    drawing.page.height_px = pixels(height_m);
}

Result<Drawing> open(const std::filesystem::path& file, const PictureJob& job) {
    const GdalReason reason;
    constexpr std::array<const char*, 2> kDrivers = {"DXF", nullptr};
    Drawing drawing;
    drawing.dataset.reset(
        GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, kDrivers.data()));
    if (!drawing.dataset) {
        return fail(ErrorCode::kNotAnImage, file.string(), "damaged DXF: " + reason.text());
    }
    drawing.extent = extentOf(*drawing.dataset);
    const OGREnvelope& e = drawing.extent;
    const double side = std::max(e.MaxX - e.MinX, e.MaxY - e.MinY);
    if (!e.IsInit() || !std::isfinite(side) || side <= 0.0) {
        return fail(ErrorCode::kNoData, file.string(), "the drawing has no lines");
    }
    drawing.unit_m = unitOfHeader(file).value_or(side > kLargestSite ? 0.001 : 1.0);
    chooseSize(drawing, job);
    return drawing;
}

void addLine(cairo_t* cairo, const OGRSimpleCurve& line) {
    for (int i = 0; i < line.getNumPoints(); ++i) {
        const auto add = i == 0 ? &cairo_move_to : &cairo_line_to;
        add(cairo, line.getX(i), line.getY(i));
    }
}

void addGeometry(cairo_t* cairo, const OGRGeometry& geometry) {
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbLineString:
            return addLine(cairo, *geometry.toLineString());
        case wkbPolygon:
            for (const OGRLinearRing* ring : *geometry.toPolygon()) addLine(cairo, *ring);
            return;
        case wkbMultiLineString:
        case wkbMultiPolygon:
        case wkbGeometryCollection:
            for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
                addGeometry(cairo, *part);
            }
            return;
        default:
            return;
    }
}

// Paints in the drawing's own coordinates; each geometry on its own, as paths grow slow.
bool paint(const Drawing& drawing, cairo_t* cairo, const PictureJob& job) {
    const double px_per_unit = drawing.unit_m / drawing.resolution_m;
    cairo_translate(cairo, kMargin_px, drawing.page.height_px - kMargin_px);
    cairo_scale(cairo, px_per_unit, -px_per_unit);
    cairo_translate(cairo, -drawing.extent.MinX, -drawing.extent.MinY);
    cairo_set_line_width(cairo, kLine_px / px_per_unit);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_source_rgb(cairo, 0.0, 0.0, 0.0);
    int count = 0;
    return forEachGeometry(*drawing.dataset, [&](const OGRGeometry& geometry) {
        addGeometry(cairo, geometry);
        cairo_stroke(cairo);
        return ++count % 1000 != 0 || !wasCanceled(job, 0.5);
    });
}

PlanPlacement placementOf(const Drawing& drawing) {
    PlanPlacement placement{.resolution_m = drawing.resolution_m};
    const double margin_m = kMargin_px * drawing.resolution_m;
    const Point<World> corner{drawing.unit_m * drawing.extent.MinX - margin_m,
                              drawing.unit_m * drawing.extent.MinY - margin_m};
    if (std::hypot(corner.x, corner.y) <= kLocal_m) placement.origin.position = corner;
    return placement;
}

}  // namespace

Result<Picture> loadDxf(const std::filesystem::path& file, const PictureJob& job) {
    const auto drawing = open(file, job);
    if (!drawing) return tl::make_unexpected(drawing.error());
    auto canvas = Canvas::create(drawing->page.width_px, drawing->page.height_px, file.string());
    if (!canvas) return tl::make_unexpected(canvas.error());
    const GdalReason reason;
    if (!paint(*drawing, canvas->cairo(), job) || wasCanceled(job, 0.9)) {
        return fail(ErrorCode::kCanceled, file.string());
    }
    return Picture{mipPyramid(std::move(*canvas).grey()), placementOf(*drawing)};
}

Result<PlanDescription> describeDxf(const std::filesystem::path& file, const PictureJob& job) {
    return open(file, job).map([](const Drawing& drawing) {
        return PlanDescription{"DXF", {drawing.page}};
    });
}

}  // namespace hedr
