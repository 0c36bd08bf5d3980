#pragma once

#include "core/site/raster/picture.h"

namespace hedr {

// The first ground overlay of a KML, or of the KMZ that holds both: its image (a file beside it) in
// its box of latitudes and longitudes. Errors: those of loadPlan, of the KML or of its image.
Result<Picture> loadGroundOverlay(const std::filesystem::path& file, const PictureJob& job);

Result<PlanDescription> describeGroundOverlay(const std::filesystem::path& file);

}  // namespace hedr
