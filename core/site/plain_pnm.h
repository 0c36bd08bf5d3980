#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// The Netpbm pictures that GDAL does not read: plain text (P1, P2, P3) and packed bits (P4). Robot
// maps are kept as P2 now and then.
bool isPlainPnm(const std::filesystem::path& file);

// Errors: kNotAnImage, kImageTooLarge.
Result<PlanLevel> parsePlainPnm(std::string_view bytes, const std::string& path);

}  // namespace hedr
