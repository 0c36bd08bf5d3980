#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/site/plan.h"
#include "core/site/site.h"

namespace hedr {

// What other programs take a plan as.
enum class PlanCopyKind {
    kGeoTiff,
    kPng,     // with its world file
    kRosMap,  // yaml, with its pgm
};

// A plan as it lies in the world and is to be written for another program.
struct PlanCopy {
    PlanImage plan{};  // straightened, where its photo was
    std::optional<PlanCrop> crop{};
    std::optional<GeoTie> geo_tie{};  // of the world; a GeoTIFF needs it
    PlanCopyKind kind = PlanCopyKind::kPng;
    std::filesystem::path file{};
};

// Gives the files that were written, the named one first.
// Errors: kFileUnwritable (also the image that is read), kDiskFull, kCanceled, kBadValue (no tie);
// those of readPart.
Result<std::vector<std::filesystem::path>> writePlanCopy(const PlanCopy& copy,
                                                         const PlanProgress& progress = {});

// What is read must not be written over; names of no file count for nothing. Error:
// kFileUnwritable.
Result<void> refuseOverwriting(const std::vector<std::filesystem::path>& read,
                               const std::filesystem::path& written);

}  // namespace hedr
