#include "core/site/plan_copy.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "core/site/placement_export.h"
#include "core/site/plan_cropping.h"
#include "core/site/raster/blank_pixels.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr double kReadingShare = 0.3;    // of a copy's time
constexpr int kPixelsAtATime = 1 << 22;  // of a file, between two looks at the progress

// A level that stays in its file, some rows after the others.
Result<PlanLevel> readRowByRow(const PlanLevel& level, const PlanPart& part, const fs::path& file,
                               const PlanProgress& progress) {
    const auto pixels = blankPixels(part.width_px, part.height_px, level.channels, file.string());
    if (!pixels) return tl::make_unexpected(pixels.error());
    const int rows = std::max(1, kPixelsAtATime / part.width_px);
    std::uint8_t* to = (*pixels)->data();
    for (int row = 0; row < part.height_px; row += rows) {
        if (progress && !progress(kReadingShare * row / part.height_px))
            return fail(ErrorCode::kCanceled, file.string());
        const auto strip = readPart(level, {part.left_px, part.top_px + row, part.width_px,
                                            std::min(rows, part.height_px - row)});
        if (!strip) return tl::make_unexpected(strip.error());
        std::memcpy(to, strip->pixels->data(), strip->pixels->size());
        to += strip->pixels->size();
    }
    return PlanLevel{part.width_px, part.height_px, level.channels, *pixels};
}

Result<PlanLevel> readWatched(const PlanImage& plan, const PlanPart& part,
                              const PlanProgress& progress) {
    const PlanLevel& level = plan.levels.front();
    if (!level.read_part) return readPart(level, part);
    return readRowByRow(level, part, plan.image_file, progress);
}

// The file that is named, and the one beside it.
std::vector<fs::path> filesOf(const PlanCopy& copy) {
    switch (copy.kind) {
        case PlanCopyKind::kPng:
            return {copy.file, worldFileOfPng(copy.file)};
        case PlanCopyKind::kRosMap:
            return {copy.file, rosImageBeside(copy.file)};
        case PlanCopyKind::kGeoTiff:
            break;
    }
    return {copy.file};
}

Result<void> write(const PlanCopy& copy, const PlanLevel& pixels, const PlanPlacement& placement,
                   const PlanProgress& progress) {
    switch (copy.kind) {
        case PlanCopyKind::kPng:
            return exportPng(pixels, placement, copy.file, progress);
        case PlanCopyKind::kRosMap:
            return exportRosMap(pixels, placement, copy.file, progress);
        case PlanCopyKind::kGeoTiff:
            break;
    }
    return exportGeoTiff(pixels, placement, *copy.geo_tie, copy.file, progress);
}

PlanProgress afterReading(const PlanProgress& progress) {
    if (!progress) return {};
    return [&progress](double share) {
        return progress(kReadingShare + (1.0 - kReadingShare) * share);
    };
}

}  // namespace

Result<std::vector<fs::path>> writePlanCopy(const PlanCopy& copy, const PlanProgress& progress) {
    if (copy.kind == PlanCopyKind::kGeoTiff && !copy.geo_tie)
        return fail(ErrorCode::kBadValue, copy.file.string(), "no tie to the globe");
    std::vector<fs::path> files = filesOf(copy);
    if (files.front() == files.back() && files.size() > 1)
        return fail(ErrorCode::kBadValue, copy.file.string(), "its image would have the same name");
    for (const fs::path& file : files) {
        const auto other = refuseOverwriting({copy.plan.image_file}, file);
        if (!other) return tl::make_unexpected(other.error());
    }
    const PlanLevel& whole = copy.plan.levels.front();
    PlanPart part{0, 0, whole.width_px, whole.height_px};
    PlanPlacement placement = copy.plan.placement;
    if (copy.crop) {
        part = partOf(*copy.crop, whole);
        placement = placementOfPart(placement, part, whole.height_px);
    }
    const auto pixels = readWatched(copy.plan, part, progress);
    if (!pixels) return tl::make_unexpected(pixels.error());
    return write(copy, *pixels, placement, afterReading(progress)).map([&files] {
        return std::move(files);
    });
}

Result<void> refuseOverwriting(const std::vector<fs::path>& read, const fs::path& written) {
    std::error_code ignored;
    for (const fs::path& file : read) {
        if (!fs::equivalent(file, written, ignored)) continue;
        return fail(ErrorCode::kFileUnwritable, written.string(), "it is a file that is read");
    }
    return {};
}

}  // namespace hedr
