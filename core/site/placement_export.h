#pragma once

#include <filesystem>

#include "core/result.h"
#include "core/site/geo_tie.h"
#include "core/site/plan.h"

namespace hedr {

// Where a plan lies, for other programs; core/site/placement_file.h writes our own plan.toml. Each
// file is replaced in one step. Errors of all: kFileUnwritable, kDiskFull; of those that write an
// image, kCanceled, which leaves nothing, and those of readWhole.

// In the world's metres.
Result<void> exportWorldFile(const PlanPlacement& placement, int height_px,
                             const std::filesystem::path& file);

// The map that ROS map_server reads: `yaml_file` and its image, a .pgm of that name beside it, in
// grey. Error: kFileUnwritable (there is such a .pgm of something else).
std::filesystem::path rosImageBeside(const std::filesystem::path& yaml_file);
Result<void> exportRosMap(const PlanLevel& image, const PlanPlacement& placement,
                          const std::filesystem::path& yaml_file,
                          const PlanProgress& progress = {});

// A PNG with its world file beside it, in the world's metres. Error: kFileUnwritable (there is such
// a .pgw of something else).
std::filesystem::path worldFileOfPng(const std::filesystem::path& png_file);
Result<void> exportPng(const PlanLevel& image, const PlanPlacement& placement,
                       const std::filesystem::path& png_file, const PlanProgress& progress = {});

// With tiles and overviews, in a transverse Mercator projection about the tie's point: its numbers
// are the world's where the world's y axis points to the north, and it does not stretch as a zone
// of UTM does.
// Error: kBadValue (a tie at a pole, a plan out of its reach).
Result<void> exportGeoTiff(const PlanLevel& image, const PlanPlacement& placement,
                           const GeoTie& tie, const std::filesystem::path& tif_file,
                           const PlanProgress& progress = {});

}  // namespace hedr
