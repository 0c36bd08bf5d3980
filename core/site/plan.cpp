#include "core/site/plan.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "core/site/mip_pyramid.h"
#include "core/site/placement_file.h"
#include "core/site/plain_pnm.h"
#include "core/site/plan_format.h"
#include "core/site/raster/dxf_drawing.h"
#include "core/site/raster/ground_overlay.h"
#include "core/site/raster/pdf_page.h"
#include "core/site/raster/raster_picture.h"
#include "core/site/raster/svg_drawing.h"
#include "core/text/number.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

// What a placement file says, if there is one.
struct GivenPlacement {
    std::filesystem::path image_file;
    std::optional<PlanPlacement> placement{};
};

Result<GivenPlacement> placementIn(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_other(file, ignored)) {
        return fail(ErrorCode::kFileUnreadable, file.string(), "not a regular file");
    }
    return loadPlacement(file).map([](const PlacementFile& found) {
        return GivenPlacement{found.image_file, found.placement};
    });
}

// The placement that lies beside an image and names it, else the default one.
Result<GivenPlacement> placementBeside(const std::filesystem::path& image) {
    for (const char* extension : {".toml", ".yaml", ".yml"}) {
        auto file = image;
        file.replace_extension(extension);
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored)) continue;
        auto found = loadPlacement(file);
        if (!found) return tl::make_unexpected(found.error());
        if (found->image_file.filename() == image.filename()) {
            return GivenPlacement{image, found->placement};
        }
    }
    return GivenPlacement{image};
}

Result<PlanLevel> readPlainPnm(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&](const std::string& bytes) { return parsePlainPnm(bytes, file.string()); });
}

Result<Picture> loadPicture(const std::filesystem::path& file, const PictureJob& job) {
    if (const auto checked = checkPlanFile(file); !checked) {
        return tl::make_unexpected(checked.error());
    }
    switch (planFormatOf(file)) {
        case PlanFormat::kPlainPnm:
            return readPlainPnm(file).map(
                [](const PlanLevel& level) { return Picture{mipPyramid(level)}; });
        case PlanFormat::kPdf:
            return loadPdf(file, job);
        case PlanFormat::kSvg:
            return loadSvg(file, job);
        case PlanFormat::kDxf:
            return loadDxf(file, job);
        case PlanFormat::kGroundOverlay:
            return loadGroundOverlay(file, job);
        case PlanFormat::kRaster:
            break;
    }
    return loadRaster(file, job);
}

Result<PlanDescription> describePicture(const std::filesystem::path& file, const PictureJob& job) {
    if (const auto checked = checkPlanFile(file); !checked) {
        return tl::make_unexpected(checked.error());
    }
    switch (planFormatOf(file)) {
        case PlanFormat::kPlainPnm:
            return readPlainPnm(file).map([](const PlanLevel& level) {
                return PlanDescription{"PNM", {{level.width_px, level.height_px}}};
            });
        case PlanFormat::kPdf:
            return describePdf(file, job);
        case PlanFormat::kSvg:
            return describeSvg(file, job);
        case PlanFormat::kDxf:
            return describeDxf(file, job);
        case PlanFormat::kGroundOverlay:
            return describeGroundOverlay(file);
        case PlanFormat::kRaster:
            break;
    }
    return describeRaster(file);
}

// A small file may ask for more memory than there is.
template <class Work>
std::invoke_result_t<Work> fitting(const std::filesystem::path& file, Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return fail(ErrorCode::kImageTooLarge, file.string(), "it does not fit into memory");
}

// From microscopes to continents; more is a slip.
bool isSane(double resolution_m) { return resolution_m > 1e-7 && resolution_m < 1e6; }

// A named image that is missing: which file names it?
Error named(Error error, const std::filesystem::path& by) {
    if (error.code == ErrorCode::kFileMissing) error.detail = "named in " + by.string();
    return error;
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

Result<PlanLevel> readPart(const PlanLevel& level, const PlanPart& part) {
    if (level.read_part) return level.read_part(part);
    const bool inside = part.left_px >= 0 && part.top_px >= 0 && part.width_px > 0 &&
                        part.height_px > 0 && part.width_px <= level.width_px - part.left_px &&
                        part.height_px <= level.height_px - part.top_px;
    if (!level.pixels || !inside) return fail(ErrorCode::kNoData, "plan", "no such pixels");
    if (part.width_px == level.width_px && part.height_px == level.height_px) return level;
    const auto channels = static_cast<std::size_t>(level.channels);
    const std::size_t stride = channels * static_cast<std::size_t>(level.width_px);
    const std::size_t length = channels * static_cast<std::size_t>(part.width_px);
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(
        length * static_cast<std::size_t>(part.height_px));
    const std::uint8_t* from = level.pixels->data() +
                               stride * static_cast<std::size_t>(part.top_px) +
                               channels * static_cast<std::size_t>(part.left_px);
    for (std::size_t row = 0; row < static_cast<std::size_t>(part.height_px); ++row) {
        std::memcpy(pixels->data() + length * row, from + stride * row, length);
    }
    return PlanLevel{part.width_px, part.height_px, level.channels, pixels};
}

Result<PlanLevel> readWhole(const PlanLevel& level) {
    return readPart(level, {0, 0, level.width_px, level.height_px});
}

namespace {

Result<PlanImage> loadUnguarded(const std::filesystem::path& file, const PlanProgress& progress,
                                const PlanPreview& on_preview, const PlanChoice& choice) {
    const bool placement_first = isPlacementFile(file);
    const auto given = placement_first ? placementIn(file) : placementBeside(file);
    if (!given) return tl::make_unexpected(given.error());
    const auto plan_of = [&](Picture picture) {
        const bool said = given->placement || !picture.placement;
        return PlanImage{given->image_file,
                         std::move(picture.levels),
                         given->placement.value_or(picture.placement.value_or(PlanPlacement{})),
                         said ? std::nullopt : picture.geo_tie,
                         picture.focal_length,
                         !given->placement && !picture.placement};
    };
    PictureJob job{choice, 0, progress};
    if (on_preview) job.on_preview = [&](const Picture& picture) { on_preview(plan_of(picture)); };
    auto picture = loadPicture(given->image_file, job);
    if (!picture) {
        return tl::make_unexpected(placement_first ? named(picture.error(), file)
                                                   : picture.error());
    }
    if (wasCanceled(job, 1.0)) return fail(ErrorCode::kCanceled, file.string());
    PlanImage plan = plan_of(std::move(*picture));
    if (!isSane(plan.placement.resolution_m)) {
        std::string detail = "its pixels would have a side of ";
        appendNumber(detail, plan.placement.resolution_m);
        return fail(ErrorCode::kBadValue, file.string(), detail + " m");
    }
    return plan;
}

}  // namespace

Result<PlanImage> loadPlan(const std::filesystem::path& file, const PlanProgress& progress,
                           const PlanPreview& on_preview, const PlanChoice& choice) {
    return fitting(file, [&] { return loadUnguarded(file, progress, on_preview, choice); });
}

Result<PlanDescription> describePlan(const std::filesystem::path& file, const PlanChoice& choice) {
    const bool placement_first = isPlacementFile(file);
    const auto given = placement_first ? placementIn(file) : placementBeside(file);
    if (!given) return tl::make_unexpected(given.error());
    auto described = fitting(file, [&] { return describePicture(given->image_file, {choice}); });
    if (!described) {
        return tl::make_unexpected(placement_first ? named(described.error(), file)
                                                   : described.error());
    }
    if (given->placement) described->resolution_m = given->placement->resolution_m;
    return described;
}

Result<PlanLevel> planThumbnail(const std::filesystem::path& file, int side_px) {
    if (isPlacementFile(file)) {
        return loadPlacement(file).and_then([&](const PlacementFile& placement) {
            return planThumbnail(placement.image_file, side_px);
        });
    }
    return loadPicture(file, {{}, side_px}).map([&](const Picture& picture) {
        return fittedInto(picture.levels, side_px);
    });
}

}  // namespace hedr
