#include "core/site/raster_file.h"

#include <array>
#include <utility>

#include "core/site/plan_format.h"
#include "core/site/raster/raster_pixels.h"

namespace hedr {

Result<PlanLevel> readRaster(const std::filesystem::path& file, const PlanProgress& progress) {
    if (const auto checked = checkPlanFile(file); !checked) {
        return tl::make_unexpected(checked.error());
    }
    const GdalReason reason;
    auto source = openRaster(file.string(), reason);
    if (!source) return tl::make_unexpected(source.error());
    const Dataset dataset = asBytes(std::move(*source));
    if (!dataset) return notAnImage(file.string(), reason);
    return readWindow(*dataset, wholeWindow(*dataset), file.string(), progress);
}

Result<void> savePlanImage(const PlanLevel& image, const std::filesystem::path& png_file) {
    const GdalReason reason;
    const int bands = image.channels == 1 ? 1 : 3;
    GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
    if (!memory || !png)
        return fail(ErrorCode::kFileUnwritable, png_file.string(), "no PNG driver");
    const Dataset picture(
        memory->Create("", image.width_px, image.height_px, bands, GDT_Byte, nullptr));
    std::array<int, 3> order = {3, 2, 1};
    if (bands == 1) order[0] = 1;
    auto* pixels = const_cast<std::uint8_t*>(image.pixels->data());  // GDAL only reads them
    const bool copied =
        picture &&
        picture->RasterIO(GF_Write, 0, 0, image.width_px, image.height_px, pixels, image.width_px,
                          image.height_px, GDT_Byte, bands, order.data(), image.channels,
                          static_cast<GSpacing>(image.channels) * image.width_px, 1,
                          nullptr) == CE_None;
    const Dataset written(
        copied ? png->CreateCopy(png_file.c_str(), picture.get(), FALSE, nullptr, nullptr, nullptr)
               : nullptr);
    if (!written) return fail(ErrorCode::kFileUnwritable, png_file.string(), reason.text());
    return {};
}

}  // namespace hedr
