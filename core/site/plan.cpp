#include "core/site/plan.h"

#include "core/site/mip_pyramid.h"
#include "core/site/placement_file.h"
#include "core/site/plain_pnm.h"
#include "core/site/raster_file.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

constexpr double kShareOfReading = 0.9;  // of the time to load; the rest makes the pyramid

// The placement that lies beside an image and names it, else the default one.
Result<PlacementFile> placementBeside(const std::filesystem::path& image) {
    for (const char* extension : {".toml", ".yaml", ".yml"}) {
        auto file = image;
        file.replace_extension(extension);
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored)) continue;
        auto found = loadPlacement(file);
        if (!found) return found;
        if (found->image_file.filename() == image.filename()) {
            return PlacementFile{image, found->placement};
        }
    }
    return PlacementFile{image, {}};
}

Result<PlanLevel> readImage(const std::filesystem::path& file, const PlanProgress& progress) {
    if (!isPlainPnm(file)) return readRaster(file, progress);
    return readTextFile(file).and_then(
        [&](const std::string& bytes) { return parsePlainPnm(bytes, file.string()); });
}

}  // namespace

Transform<World, Plan> worldFromPlan(const PlanPlacement& placement, int height_px) {
    // Metres from the lower left corner, y up.
    Eigen::Matrix2d flip;
    flip << placement.resolution_m, 0.0, 0.0, -placement.resolution_m;
    return rigidTransform<World, Plan>(placement.origin) *
           Transform<Plan, Plan>(flip, {0.0, height_px * placement.resolution_m});
}

Transform<World, Plan> PlanImage::worldFromPlan() const {
    return hedr::worldFromPlan(placement, levels.front().height_px);
}

Result<PlanImage> loadPlan(const std::filesystem::path& file, const PlanProgress& progress) {
    const bool placement_first = isPlacementFile(file);
    const auto placement = placement_first ? loadPlacement(file) : placementBeside(file);
    if (!placement) return tl::make_unexpected(placement.error());
    PlanProgress reading;
    if (progress) reading = [&](double share) { return progress(kShareOfReading * share); };
    auto raster = readImage(placement->image_file, reading);
    if (!raster) {
        Error error = raster.error();
        if (placement_first && error.code == ErrorCode::kFileMissing) {
            error.detail = "named in " + file.string();
        }
        return tl::make_unexpected(error);
    }
    PlanImage plan{placement->image_file, mipPyramid(*raster), placement->placement};
    if (progress && !progress(1.0)) return fail(ErrorCode::kCanceled, file.string());
    return plan;
}

}  // namespace hedr
