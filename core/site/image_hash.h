#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/site/site.h"

namespace hedr {

// An image of a site that is not as it was when it was aligned.
struct ChangedImage {
    enum class Why : unsigned char { kMissing, kUnreadable, kOtherContent };

    std::size_t floor = 0;  // index in the site
    std::size_t plan = 0;   // index in the floor
    std::filesystem::path image_file;
    Why why{};
    friend bool operator==(const ChangedImage&, const ChangedImage&) = default;
};

// Asks `hash_of` once for each image file; a plan without a hash has to be there only.
using HashOfFile = std::function<Result<std::string>(const std::filesystem::path&)>;
std::vector<ChangedImage> changedImages(const Site& site, const HashOfFile& hash_of);

}  // namespace hedr
