#pragma once

#include "core/site/raster/georeference.h"
#include "core/site/raster/picture.h"

namespace hedr {

// Any raster that GDAL knows, with its own georeference or a world file's, and as its camera was
// held. Large tiled files with overviews stay in the file. Errors: those of loadPlan.
Result<Picture> loadRaster(const std::filesystem::path& file, const PictureJob& job);

// The same of an open dataset.
Result<Picture> pictureOf(Dataset source, const std::optional<Georeference>& where,
                          const std::string& path, const PictureJob& job);

// Its format and its size before it is warped.
Result<PlanDescription> describeRaster(const std::filesystem::path& file);

}  // namespace hedr
