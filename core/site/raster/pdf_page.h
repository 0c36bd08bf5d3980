#pragma once

#include "core/site/raster/picture.h"

namespace hedr {

// One page of a PDF as pixels, 1:choice.paper_scale, or where its own georeference says.
// Errors: those of loadPlan; kBadValue (no such page).
Result<Picture> loadPdf(const std::filesystem::path& file, const PictureJob& job);

Result<PlanDescription> describePdf(const std::filesystem::path& file, const PictureJob& job);

}  // namespace hedr
