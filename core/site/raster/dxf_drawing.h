#pragma once

#include "core/site/raster/picture.h"

namespace hedr {

// The lines of a DXF, black on white, where the drawing has them. $INSUNITS says its unit; without
// it a drawing larger than a kilometre is in millimetres, else in metres. Errors: those of
// loadPlan; kNoData (no lines).
Result<Picture> loadDxf(const std::filesystem::path& file, const PictureJob& job);

Result<PlanDescription> describeDxf(const std::filesystem::path& file, const PictureJob& job);

}  // namespace hedr
