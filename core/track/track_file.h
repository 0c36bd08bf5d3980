#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "core/track/track.h"

namespace hedr {

// Reads a track.csv or truth.csv (t_s,x_m,y_m,heading_rad, variances, bias, other columns skipped)
// or a TUM file (t x y z qx qy qz qw). Errors: kFileMissing, kFileEmpty, kMissingColumn, kBadFormat
// (path:line).
Result<std::vector<TrackPoint>> loadTrack(const std::filesystem::path& file);

// Writes CSV with all digits; TUM where the name ends in .tum or .txt.
Result<void> saveTrack(const std::filesystem::path& file, const std::vector<TrackPoint>& track);

}  // namespace hedr
