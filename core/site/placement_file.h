#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"
#include "core/site/plan.h"

namespace hedr {

// Where the image named in a small file lies on the ground. README.md lists the keys.
struct PlacementFile {
    std::filesystem::path image_file;
    PlanPlacement placement{};
};

// By its name: .toml is ours, .yaml and .yml are ROS maps.
bool isPlacementFile(const std::filesystem::path& file);

// Errors: kFileMissing, kFileUnreadable, kBadFormat (path:line), kMissingKey, kBadValue
// (path:line).
Result<PlacementFile> loadPlacement(const std::filesystem::path& file);

// The same of a text; the name says which format it is.
Result<PlacementFile> parsePlacement(const std::string& text, const std::filesystem::path& file);

// Writes our format. An image below the file's folder is named relative to it, as is a name without
// a folder; another one by its whole path. Errors: kFileUnwritable, kDiskFull.
Result<void> savePlacement(const PlacementFile& placement, const std::filesystem::path& toml_file);

}  // namespace hedr
