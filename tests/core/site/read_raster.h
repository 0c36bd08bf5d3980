#pragma once

#include <filesystem>

#include "core/site/plan.h"

namespace hedr {

// The pixels of an image file, whatever it says of where it lies.
inline Result<PlanLevel> readRaster(const std::filesystem::path& file,
                                    const PlanProgress& progress = {}) {
    return loadPlan(file, progress).map([](const PlanImage& plan) { return plan.levels.front(); });
}

}  // namespace hedr
