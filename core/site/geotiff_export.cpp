#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "core/site/placement_export.h"
#include "core/site/raster/gdal_file.h"
#include "core/site/raster/written_raster.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

OGRSpatialReference globe() {
    OGRSpatialReference system;
    system.SetWellKnownGeogCS("WGS84");
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

OGRSpatialReference projectionAbout(const GeoTie& tie) {
    OGRSpatialReference system;
    system.SetProjCS("local metres");
    system.SetWellKnownGeogCS("WGS84");
    system.SetTM(tie.at.latitude_deg, tie.at.longitude_deg, 1.0, tie.point.x, tie.point.y);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

struct Grounding {
    OGRSpatialReference system;
    std::array<double, 6> numbers{};  // GDAL's geotransform
};

// Puts the image's upper left, upper right and lower left corner where they are.
Result<Grounding> grounding(const PlanLevel& image, const PlanPlacement& placement,
                            const GeoTie& tie) {
    const double width = image.width_px;
    const double height = image.height_px;
    const auto world_from_plan = worldFromPlan(placement, image.height_px);
    const auto at = [&](Point<Plan> p) { return latLonOf(world_from_plan * p, tie); };
    Grounding result{projectionAbout(tie)};
    const OGRSpatialReference from = globe();
    const std::unique_ptr<OGRCoordinateTransformation> local_from_globe(
        OGRCreateCoordinateTransformation(&from, &result.system));
    std::array<double, 3> x{};
    std::array<double, 3> y{};
    const std::array<Point<Plan>, 3> corners = {{{0.0, 0.0}, {width, 0.0}, {0.0, height}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto corner = at(corners[i]);
        if (!corner) return tl::make_unexpected(corner.error());
        x[i] = corner->longitude_deg;
        y[i] = corner->latitude_deg;
    }
    if (!local_from_globe || !local_from_globe->Transform(3, x.data(), y.data()))
        return fail(ErrorCode::kBadValue, "geo tie", CPLGetLastErrorMsg());
    result.numbers = {x[0], (x[1] - x[0]) / width, (x[2] - x[0]) / height,
                      y[0], (y[1] - y[0]) / width, (y[2] - y[0]) / height};
    return result;
}

bool writeTiff(GDALDataset& source, const fs::path& file, WrittenShare& share) {
    GDALDriver* tiff = GetGDALDriverManager()->GetDriverByName("COG");
    if (!tiff) return false;
    GdalWords options(
        {"COMPRESS=DEFLATE", "PREDICTOR=YES", "OVERVIEW_RESAMPLING=AVERAGE", "BIGTIFF=IF_SAFER"});
    Dataset written(
        tiff->CreateCopy(file.c_str(), &source, FALSE, options.get(), &WrittenShare::ask, &share));
    if (!written) return false;
    // A full disk may show only now.
    CPLErrorReset();
    written.reset();
    return CPLGetLastErrorType() < CE_Failure;
}

// GDAL does not always say why it could not write, and takes away what it had begun.
tl::unexpected<Error> notWritten(const fs::path& file, std::uintmax_t bytes,
                                 const GdalReason& reason) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (access(folder.c_str(), W_OK) != 0)
        return fail(ErrorCode::kFileUnwritable, file.string(),
                    std::generic_category().message(errno));
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (!error && space.available < bytes) return fail(ErrorCode::kDiskFull, file.string());
    return fail(ErrorCode::kFileUnwritable, file.string(), reason.text());
}

}  // namespace

Result<void> exportGeoTiff(const PlanLevel& image, const PlanPlacement& placement,
                           const GeoTie& tie, const fs::path& tif_file,
                           const PlanProgress& progress) {
    std::error_code none;
    const fs::file_status there = fs::status(tif_file, none);
    if (fs::exists(there) && !fs::is_regular_file(there))
        return fail(ErrorCode::kFileUnwritable, tif_file.string(), "it is no ordinary file");
    const GdalReason reason;
    const auto ground = grounding(image, placement, tie);
    if (!ground) return tl::make_unexpected(ground.error());
    const auto whole = readWhole(image);
    if (!whole) return tl::make_unexpected(whole.error());
    const Dataset source = bandsOn(*whole);
    if (!source) return fail(ErrorCode::kFileUnwritable, tif_file.string(), reason.text());
    source->SetSpatialRef(&ground->system);
    std::array<double, 6> numbers = ground->numbers;
    source->SetGeoTransform(numbers.data());

    WrittenShare share(progress);
    const fs::path draft = unusedNameBeside(tif_file);
    std::error_code error;
    const bool written = writeTiff(*source, draft, share);
    if (written && !share.canceled()) fs::rename(draft, tif_file, error);
    if (written && !share.canceled() && !error) return {};
    const auto failure = notWritten(tif_file, whole->pixels->size(), reason);
    std::error_code ignored;
    fs::remove(draft, ignored);
    if (share.canceled()) return fail(ErrorCode::kCanceled, tif_file.string());
    if (error) return fail(ErrorCode::kFileUnwritable, tif_file.string(), error.message());
    return failure;
}

}  // namespace hedr
