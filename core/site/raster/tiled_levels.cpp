#include "core/site/raster/tiled_levels.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/site/mip_pyramid.h"
#include "core/site/raster/raster_pixels.h"

namespace hedr {
namespace {

constexpr double kLarge_px = 16e6;
constexpr int kHeldInMemory_px = 2048;  // the longer side of the finest level that is

// A dataset may be used by one thread at a time, and several may draw the same image. No values
// cross threads here that could do without: the file's tiles are the shared thing.
struct OpenFile {
    Dataset dataset;
    std::string path;
    std::mutex mutex;
};

bool lies(const PlanPart& part, const PlanLevel& level) {
    return part.left_px >= 0 && part.top_px >= 0 && part.width_px > 0 && part.height_px > 0 &&
           part.width_px <= level.width_px - part.left_px &&
           part.height_px <= level.height_px - part.top_px;
}

// The part of the full size, `factor` times as large as the part of a level.
RasterWindow windowOf(const PlanPart& part, double factor, GDALDataset& dataset) {
    const double left = factor * part.left_px;
    const double top = factor * part.top_px;
    return {left,
            top,
            std::min(factor * part.width_px, dataset.GetRasterXSize() - left),
            std::min(factor * part.height_px, dataset.GetRasterYSize() - top),
            part.width_px,
            part.height_px};
}

Result<PlanLevel> readLevel(GDALDataset& dataset, const PlanLevel& level, double factor,
                            const PlanPart& part, const std::string& path,
                            const PlanProgress& progress = {}) {
    if (GDALDataset* overview = overviewOf(dataset, level.width_px, level.height_px)) {
        return readWindow(*overview, windowOf(part, 1.0, *overview), path, progress);
    }
    return readWindow(dataset, windowOf(part, factor, dataset), path, progress);
}

PlanPartReader readerOf(const std::shared_ptr<OpenFile>& file, const PlanLevel& level,
                        double factor) {
    return [file, level, factor](const PlanPart& part) -> Result<PlanLevel> {
        if (!lies(part, level)) return fail(ErrorCode::kNoData, file->path);
        const std::lock_guard lock(file->mutex);
        return readLevel(*file->dataset, level, factor, part, file->path);
    };
}

}  // namespace

std::vector<PlanLevel> levelSizes(int width_px, int height_px, int channels) {
    std::vector<PlanLevel> levels{{width_px, height_px, channels}};
    while (const auto half = halfOf(levels.back())) levels.push_back(*half);
    return levels;
}

GDALDataset* overviewOf(GDALDataset& dataset, int width_px, int height_px) {
    if (dataset.GetRasterXSize() == width_px && dataset.GetRasterYSize() == height_px) {
        return &dataset;
    }
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    for (int i = 0; i < band.GetOverviewCount(); ++i) {
        GDALRasterBand* overview = band.GetOverview(i);
        if (!overview || overview->GetXSize() != width_px || overview->GetYSize() != height_px) {
            continue;
        }
        GDALDataset* whole = overview->GetDataset();
        if (whole && whole->GetRasterXSize() == width_px && whole->GetRasterYSize() == height_px &&
            whole->GetRasterCount() == dataset.GetRasterCount()) {
            return whole;
        }
    }
    return nullptr;
}

bool isTiledWithOverviews(GDALDataset& dataset) {
    int block_width = 0;
    int block_height = 0;
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    band.GetBlockSize(&block_width, &block_height);
    const double pixels = static_cast<double>(dataset.GetRasterXSize()) * dataset.GetRasterYSize();
    return pixels >= kLarge_px && block_width < dataset.GetRasterXSize() && block_height > 1 &&
           band.GetOverviewCount() > 0;
}

Result<std::vector<PlanLevel>> tiledLevels(Dataset dataset, const std::string& path,
                                           const PlanProgress& progress) {
    std::vector<PlanLevel> levels =
        levelSizes(dataset->GetRasterXSize(), dataset->GetRasterYSize(), channelsOf(*dataset));
    const auto file = std::make_shared<OpenFile>();
    file->dataset = std::move(dataset);
    file->path = path;
    double factor = 1.0;
    for (auto level = levels.begin(); level != levels.end(); ++level, factor *= 2.0) {
        if (std::max(level->width_px, level->height_px) > kHeldInMemory_px) {
            level->read_part = readerOf(file, *level, factor);
            continue;
        }
        const PlanPart whole{0, 0, level->width_px, level->height_px};
        const auto held = readLevel(*file->dataset, *level, factor, whole, path, progress);
        if (!held) return tl::make_unexpected(held.error());
        levels.erase(level, levels.end());
        for (PlanLevel& small : mipPyramid(*held)) levels.push_back(std::move(small));
        break;
    }
    return levels;
}

}  // namespace hedr
