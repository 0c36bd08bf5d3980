#include "core/site/raster_file.h"

#include <string>
#include <string_view>
#include <utility>

#include "core/site/raster/memory_file.h"
#include "core/site/raster/raster_pixels.h"
#include "core/site/raster/written_raster.h"
#include "core/text/text_file.h"

namespace hedr {

Result<void> savePlanImage(const PlanLevel& image, const std::filesystem::path& png_file,
                           const PlanProgress& progress) {
    const GdalReason reason;
    GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
    const Dataset picture = png ? bandsOn(image) : nullptr;
    if (!picture) return fail(ErrorCode::kFileUnwritable, png_file.string(), reason.text());
    // In memory first: GDAL does not tell of a disk that is full at the very end.
    const MemoryFile encoded;
    WrittenShare share(progress);
    const Dataset written(png->CreateCopy(encoded.name().c_str(), picture.get(), FALSE, nullptr,
                                          &WrittenShare::ask, &share));
    if (share.canceled()) return fail(ErrorCode::kCanceled, png_file.string());
    if (!written) return fail(ErrorCode::kFileUnwritable, png_file.string(), reason.text());
    return writeTextFile(png_file, encoded.bytes());
}

}  // namespace hedr
