#pragma once

#include <filesystem>

#include "core/result.h"

namespace hedr {

// What reads a plan's file.
enum class PlanFormat { kRaster, kPlainPnm, kPdf, kSvg, kDxf, kGroundOverlay };

// By what the file begins with, whatever its name; a DXF also by its name.
PlanFormat planFormatOf(const std::filesystem::path& file);

// A KMZ: a KML and its images in one archive.
bool isArchivedOverlay(const std::filesystem::path& file);

// Whether there is anything to read. Errors: kFileMissing, kFileUnreadable (a folder, a pipe, no
// permission), kFileEmpty.
Result<void> checkPlanFile(const std::filesystem::path& file);

}  // namespace hedr
