#pragma once

#include <filesystem>
#include <optional>

namespace hedr {

// Where the site of an image is kept: beside it, else in the program's own folder.
std::filesystem::path siteFileBeside(const std::filesystem::path& image);
std::filesystem::path siteFileInOwnFolder(const std::filesystem::path& image);

// Another site that is kept beside the image already must not be lost.
std::filesystem::path unusedSiteFile(const std::filesystem::path& image);
std::optional<std::filesystem::path> keptSiteOf(const std::filesystem::path& image);

}  // namespace hedr
