#pragma once

#include <string>
#include <vector>

#include "core/site/plan.h"
#include "core/site/raster/gdal_file.h"

namespace hedr {

// Levels without pixels, of a pyramid as mip_pyramid.h makes it.
std::vector<PlanLevel> levelSizes(int width_px, int height_px, int channels);

// The overview that has exactly this size; the dataset itself if it has; null if there is none.
GDALDataset* overviewOf(GDALDataset& dataset, int width_px, int height_px);

// Whether a file is large and made for being read in parts.
bool isTiledWithOverviews(GDALDataset& dataset);

// A pyramid whose coarse levels are in memory and whose fine ones are read from the file when they
// are drawn; GDAL keeps the newest tiles. Errors: those of readWindow.
Result<std::vector<PlanLevel>> tiledLevels(Dataset dataset, const std::string& path,
                                           const PlanProgress& progress);

}  // namespace hedr
