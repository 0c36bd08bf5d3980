#pragma once

#include <filesystem>

#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// Reads any raster that GDAL knows. Grey stays grey (palettes of greys too), more than 8 bits are
// stretched to 8, colour becomes BGRA, what is transparent becomes white.
// Errors: kFileMissing, kFileUnreadable, kNotAnImage (with GDAL's reason), kImageTooLarge,
// kCanceled.
Result<PlanLevel> readRaster(const std::filesystem::path& file, const PlanProgress& progress = {});

// Replaces the file in one step. Errors: kFileUnwritable, kDiskFull, kCanceled.
Result<void> savePlanImage(const PlanLevel& image, const std::filesystem::path& png_file,
                           const PlanProgress& progress = {});

}  // namespace hedr
