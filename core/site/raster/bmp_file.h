#pragma once

#include <string>

#include "core/site/raster/gdal_file.h"

namespace hedr {

// A BMP whose header is of version 4 or 5, which many programs write and GDAL does not read: as one
// of version 3, which has the same pixels. nullptr: it is no such file, or damaged.
Dataset openNewBmp(const std::string& file);

}  // namespace hedr
