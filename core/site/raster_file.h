#pragma once

#include <filesystem>

#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// Replaces the file in one step. Errors: kFileUnwritable, kDiskFull, kCanceled.
Result<void> savePlanImage(const PlanLevel& image, const std::filesystem::path& png_file,
                           const PlanProgress& progress = {});

}  // namespace hedr
