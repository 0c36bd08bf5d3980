#include "core/site/raster/raster_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "core/site/mip_pyramid.h"
#include "core/site/raster/exif_lens.h"
#include "core/site/raster/orientation.h"
#include "core/site/raster/raster_pixels.h"
#include "core/site/raster/tiled_levels.h"
#include "core/text/number.h"

namespace hedr {
namespace {

constexpr double kShareOfReading = 0.9;    // of the time to load; the rest makes the pyramid
constexpr double kWorthAPreview_px = 4e6;  // smaller images are there at once
constexpr int kLongestPreview_px = 2048;

// World files are kept beside images that cannot say themselves where they lie.
Result<std::optional<Georeference>> placeOf(GDALDataset& dataset,
                                            const std::filesystem::path& file) {
    const bool own = isFormat(dataset, "GTiff") || isFormat(dataset, "MBTiles");
    auto from_gdal = georeferenceOf(dataset, file.string());
    if (own && from_gdal && *from_gdal) return from_gdal;
    const auto world_file = worldFileBeside(file);
    if (!world_file) return from_gdal;
    return loadWorldFile(*world_file).map([&](const WorldFile& numbers) {
        const OGRSpatialReference* system = dataset.GetSpatialRef();
        Georeference where{groundFromPlan(numbers), system ? *system : OGRSpatialReference()};
        where.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        return std::optional(where);
    });
}

// Where a phone lay on its side, the file says so instead of turning its pixels.
int exifOrientationOf(GDALDataset& dataset) {
    const char* value = dataset.GetMetadataItem("EXIF_Orientation");
    return value ? std::atoi(value) : 1;
}

std::optional<double> exifNumber(GDALDataset& dataset, const char* tag) {
    const char* value = dataset.GetMetadataItem(tag);
    if (!value) return {};
    std::string_view text(value);
    if (text.starts_with('(') && text.ends_with(')')) text = text.substr(1, text.size() - 2);
    const auto number = parseNumber(text);
    return number && std::isfinite(*number) && *number > 0.0 ? number : std::nullopt;
}

// Pixels per millimetre; the unit's tag is 2 for an inch, which is meant without it too.
std::optional<double> sensorPxPerMm(GDALDataset& dataset) {
    const auto resolution = exifNumber(dataset, "EXIF_FocalPlaneXResolution");
    const double unit = exifNumber(dataset, "EXIF_FocalPlaneResolutionUnit").value_or(2.0);
    if (!resolution) return {};
    if (unit == 2.0) return *resolution / 25.4;
    if (unit == 3.0) return *resolution / 10.0;
    return {};
}

std::optional<FocalLength> focalLengthIn(GDALDataset& dataset) {
    return focalLengthOf(
        {exifNumber(dataset, "EXIF_FocalLengthIn35mmFilm"), exifNumber(dataset, "EXIF_FocalLength"),
         sensorPxPerMm(dataset), exifNumber(dataset, "EXIF_DigitalZoomRatio"),
         exifNumber(dataset, "EXIF_PixelXDimension"), exifNumber(dataset, "EXIF_PixelYDimension")},
        dataset.GetRasterXSize(), dataset.GetRasterYSize());
}

RasterWindow smallWindow(GDALDataset& dataset, int longest_side_px) {
    RasterWindow window = wholeWindow(dataset);
    const double factor = longest_side_px / std::max(window.width, window.height);
    if (factor < 1.0) {
        window.width_px = std::max(1, static_cast<int>(std::lround(factor * window.width)));
        window.height_px = std::max(1, static_cast<int>(std::lround(factor * window.height)));
    }
    return window;
}

// JPEG decodes an eighth of the size much faster than the whole.
void givePreview(GDALDataset& dataset, int orientation, const std::string& path,
                 const Picture& frame, const PictureJob& job) {
    const double pixels = static_cast<double>(dataset.GetRasterXSize()) * dataset.GetRasterYSize();
    if (!job.on_preview || !isFormat(dataset, "JPEG") || pixels < kWorthAPreview_px) return;
    std::vector<PlanLevel> levels =
        levelSizes(dataset.GetRasterXSize(), dataset.GetRasterYSize(), channelsOf(dataset));
    const auto coarse = std::ranges::find_if(levels, [](const PlanLevel& level) {
        return std::max(level.width_px, level.height_px) <= kLongestPreview_px;
    });
    if (coarse == levels.end()) return;
    GDALDataset* scaled = overviewOf(dataset, coarse->width_px, coarse->height_px);
    if (!scaled) return;
    const auto pixels_read = readWindow(*scaled, wholeWindow(*scaled), path);
    if (!pixels_read) return;
    levels.erase(coarse, levels.end());
    for (PlanLevel& level : mipPyramid(*pixels_read)) levels.push_back(std::move(level));
    Picture preview = frame;
    for (const PlanLevel& level : levels) preview.levels.push_back(oriented(level, orientation));
    job.on_preview(preview);
}

Result<std::vector<PlanLevel>> allLevels(GDALDataset& dataset, int orientation,
                                         const std::string& path, const PictureJob& job) {
    PlanProgress reading;
    if (job.progress) reading = [&](double share) { return job.progress(kShareOfReading * share); };
    return readWindow(dataset, wholeWindow(dataset), path, reading).map([&](PlanLevel level) {
        return mipPyramid(oriented(std::move(level), orientation));
    });
}

}  // namespace

Result<Picture> pictureOf(Dataset source, const std::optional<Georeference>& where,
                          const std::string& path, const PictureJob& job) {
    const GdalReason reason;
    const int orientation = where ? 1 : exifOrientationOf(*source);
    const bool tiled = isTiledWithOverviews(*source);
    Picture picture;
    if (!where) picture.focal_length = focalLengthIn(*source);
    Dataset dataset = asBytes(std::move(source));
    if (!dataset) return notAnImage(path, reason);
    if (where) {
        auto ground = onGround(std::move(dataset), *where, path);
        if (!ground) return tl::make_unexpected(ground.error());
        dataset = std::move(ground->dataset);
        picture.placement = ground->placement;
        picture.geo_tie = ground->geo_tie;
    }
    if (job.longest_side_px > 0) {
        return readWindow(*dataset, smallWindow(*dataset, job.longest_side_px), path, job.progress)
            .map([&](PlanLevel level) {
                return Picture{{oriented(std::move(level), orientation)}};
            });
    }
    if (!tiled) givePreview(*dataset, orientation, path, picture, job);
    auto levels = tiled ? tiledLevels(std::move(dataset), path, job.progress)
                        : allLevels(*dataset, orientation, path, job);
    if (!levels) return tl::make_unexpected(levels.error());
    picture.levels = std::move(*levels);
    return picture;
}

Result<Picture> loadRaster(const std::filesystem::path& file, const PictureJob& job) {
    const GdalReason reason;
    auto source = openRaster(file.string(), reason);
    if (!source) return tl::make_unexpected(source.error());
    const auto where = placeOf(**source, file);
    if (!where) return tl::make_unexpected(where.error());
    return pictureOf(std::move(*source), *where, file.string(), job);
}

Result<PlanDescription> describeRaster(const std::filesystem::path& file) {
    const GdalReason reason;
    auto source = openRaster(file.string(), reason);
    if (!source) return tl::make_unexpected(source.error());
    const PlanLevel size = oriented({(*source)->GetRasterXSize(), (*source)->GetRasterYSize()},
                                    exifOrientationOf(**source));
    const std::string driver = (*source)->GetDriver()->GetDescription();
    PlanDescription description{driver == "GTiff" ? "TIFF" : driver,
                                {{size.width_px, size.height_px}}};
    const auto where = placeOf(**source, file);
    if (!where || !*where) return description;  // loading it says what is wrong
    const auto ground = onGround(std::move(*source), **where, file.string());
    if (ground) description.resolution_m = ground->placement.resolution_m;
    return description;
}

}  // namespace hedr
