#pragma once

#include "core/site/plan.h"
#include "core/site/raster/gdal_file.h"

namespace hedr {

// A part of a dataset and how many pixels it becomes.
struct RasterWindow {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
    int width_px = 0;
    int height_px = 0;
};
RasterWindow wholeWindow(GDALDataset& dataset);

// A view of 8-bit grey or colour; the dataset itself where it is one. Null where GDAL fails.
Dataset asBytes(Dataset source);

// 1 for grey, 4 for BGRA, of a dataset of bytes.
int channelsOf(GDALDataset& dataset);

// Reads a window of a dataset of bytes: grey or BGRA, what is transparent on white. Where it has
// fewer pixels than the dataset, they are means, taken from overviews where there are any.
// Errors: kImageTooLarge, kNotAnImage, kCanceled.
Result<PlanLevel> readWindow(GDALDataset& dataset, const RasterWindow& window,
                             const std::string& path, const PlanProgress& progress = {});

}  // namespace hedr
