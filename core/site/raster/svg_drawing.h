#pragma once

#include "core/site/raster/picture.h"

namespace hedr {

// An SVG as pixels, 1:choice.paper_scale. Where it gives its size without a unit, 96 of them are an
// inch, as browsers take it. Errors: those of loadPlan.
Result<Picture> loadSvg(const std::filesystem::path& file, const PictureJob& job);

Result<PlanDescription> describeSvg(const std::filesystem::path& file, const PictureJob& job);

}  // namespace hedr
