#include "core/site/image_hash.h"

#include <map>
#include <optional>

namespace hedr {
namespace {

namespace fs = std::filesystem;

using Why = ChangedImage::Why;

std::optional<Why> changeOf(const SitePlan& plan, const Result<std::string>& hash) {
    if (!hash && hash.error().code == ErrorCode::kFileMissing) return Why::kMissing;
    if (!hash && hash.error().code == ErrorCode::kCanceled) return std::nullopt;  // not known
    if (!hash) return Why::kUnreadable;
    if (!plan.sha256.empty() && plan.sha256 != *hash) return Why::kOtherContent;
    return std::nullopt;
}

}  // namespace

std::vector<ChangedImage> changedImages(const Site& site, const HashOfFile& hash_of) {
    std::vector<ChangedImage> changed;
    std::map<fs::path, Result<std::string>> hashes;
    for (std::size_t f = 0; f < site.floors.size(); ++f) {
        const std::vector<SitePlan>& plans = site.floors[f].plans;
        for (std::size_t p = 0; p < plans.size(); ++p) {
            const fs::path& file = plans[p].image_file;
            if (!hashes.contains(file)) hashes.emplace(file, hash_of(file));
            if (const auto why = changeOf(plans[p], hashes.at(file)))
                changed.push_back({f, p, file, *why});
        }
    }
    return changed;
}

}  // namespace hedr
