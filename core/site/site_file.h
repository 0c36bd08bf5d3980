#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"
#include "core/site/site.h"

namespace hedr {

inline constexpr const char* kSiteFileExtension = ".site.toml";

// A site as text, docs/site_file.md lists the keys. Images below `base_folder` are named relative
// to it, others by their whole path; without one, paths stand as they are.
std::string siteText(const Site& site, const std::filesystem::path& base_folder);

// The site of a text; relative images lie below `base_folder`, `name` stands in the errors:
// kBadFormat, kMissingKey, kBadValue (name:line).
Result<Site> parseSite(std::string_view text, const std::string& name,
                       const std::filesystem::path& base_folder);

// Whether the images are there is not asked. Errors: those of parseSite, kFileMissing,
// kFileUnreadable, kFileTooLarge.
Result<Site> readSite(const std::filesystem::path& file);

// Replaces the file in one step, by nothing that readSite would refuse. Errors: kFileUnwritable,
// kDiskFull; kBadValue (a number that is not finite, a name that is no UTF-8).
Result<void> writeSite(const Site& site, const std::filesystem::path& file);

}  // namespace hedr
