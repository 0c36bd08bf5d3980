#include "core/site/raster/georeference.h"

#include <gdal_utils.h>

#include <array>
#include <cmath>
#include <sstream>

#include "core/geometry/angle.h"

namespace hedr {
namespace {

// A world file in metres and one in degrees look alike; no floor plan has pixels this small.
constexpr double kSmallestPixel = 5e-4;
// Beyond this from the origin, coordinates are those of a country's grid, not of a site.
constexpr double kLocal_m = 100e3;
// UTM stays within 0.1 % of true metres; Web Mercator does not.
constexpr double kTrueScale = 0.003;
constexpr double kStep_m = 10.0;

using Affine = std::array<double, 6>;

Affine affineOf(const Transform<Ground, Plan>& t) {
    const Eigen::Matrix2d& m = t.linear();
    return {t.offset().x(), m(0, 0), m(0, 1), t.offset().y(), m(1, 0), m(1, 1)};
}

bool isSimilarity(const Eigen::Matrix2d& m) {
    // y goes down in the plan and up on the ground.
    const double size = std::sqrt(std::abs(m.determinant()));
    return m.determinant() < 0.0 && std::abs(m(0, 0) + m(1, 1)) <= 1e-6 * size &&
           std::abs(m(1, 0) - m(0, 1)) <= 1e-6 * size;
}

// How a system's coordinates lie on the globe around a place.
struct OnGlobe {
    LatLon at{};
    double bearing_of_y_rad = 0.0;
    double scale = 1.0;  // units of the system per metre
};

// North and east in metres from one place to another one near by, on the ellipsoid of WGS 84.
Eigen::Vector2d northEast_m(LatLon from, LatLon to) {
    constexpr double kMajor_m = 6378137.0;
    constexpr double kSquaredEccentricity = 6.69437999014e-3;
    const double sine = std::sin(radFromDeg(from.latitude_deg));
    const double w2 = 1.0 - kSquaredEccentricity * sine * sine;
    const double along_meridian_m = kMajor_m * (1.0 - kSquaredEccentricity) / (w2 * std::sqrt(w2));
    const double across_m = kMajor_m / std::sqrt(w2) * std::cos(radFromDeg(from.latitude_deg));
    return {radFromDeg(to.latitude_deg - from.latitude_deg) * along_meridian_m,
            radFromDeg(to.longitude_deg - from.longitude_deg) * across_m};
}

std::optional<OnGlobe> onGlobe(const OGRSpatialReference& system, Point<Ground> p) {
    const Projection project = toGlobe(system);
    if (!project) return std::nullopt;
    const double step = system.IsGeographic() ? 1e-4 : kStep_m / system.GetLinearUnits();
    const auto here = latLon(*project, p);
    const auto above = latLon(*project, {p.x, p.y + step});
    if (!here || !above) return std::nullopt;
    const Eigen::Vector2d up = northEast_m(*here, *above);
    return OnGlobe{*here, std::atan2(up.y(), up.x()), step / up.norm()};
}

// A projection of its own for each image: true metres around its middle, y to the north.
OGRSpatialReference localMetres(LatLon middle) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(12);
    text << "+proj=tmerc +lat_0=" << middle.latitude_deg << " +lon_0=" << middle.longitude_deg
         << " +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
    OGRSpatialReference system;
    system.importFromProj4(text.str().c_str());
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

std::string asText(const OGRSpatialReference& system) {
    char* text = nullptr;
    system.exportToWkt(&text);
    std::string copy(text ? text : "");
    CPLFree(text);
    return copy;
}

// The same picture with this georeference and no other.
Dataset withGeoreference(GDALDataset& dataset, const Georeference& where) {
    GDALDriver* views = GetGDALDriverManager()->GetDriverByName("VRT");
    Dataset view(views->CreateCopy("", &dataset, FALSE, nullptr, nullptr, nullptr));
    if (!view) return view;
    Affine affine = affineOf(where.ground_from_plan);
    view->SetGeoTransform(affine.data());
    view->SetSpatialRef(where.system.IsEmpty() ? nullptr : &where.system);
    return view;
}

Dataset warped(GDALDataset& dataset, const OGRSpatialReference& target) {
    std::vector<std::string> words{"-of", "VRT", "-r", "bilinear", "-dstalpha"};
    if (!target.IsEmpty()) words.insert(words.end(), {"-t_srs", asText(target)});
    GdalWords arguments(std::move(words));
    GDALWarpAppOptions* options = GDALWarpAppOptionsNew(arguments.get(), nullptr);
    GDALDatasetH source = GDALDataset::ToHandle(&dataset);
    int usage_error = 0;
    Dataset view(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &source, options, &usage_error)));
    GDALWarpAppOptionsFree(options);
    return view;
}

Point<Plan> middleOf(GDALDataset& dataset) {
    return {0.5 * dataset.GetRasterXSize(), 0.5 * dataset.GetRasterYSize()};
}

// Of square pixels in a system of `unit_m`. Far from the origin the lower left corner becomes it.
PlanPlacement placementOf(const Transform<Ground, Plan>& ground_from_plan, int height_px,
                          double unit_m) {
    const Eigen::Matrix2d& m = ground_from_plan.linear();
    const Point<Ground> corner =
        ground_from_plan * Point<Plan>{0.0, static_cast<double>(height_px)};
    PlanPlacement placement;
    placement.resolution_m = unit_m * ground_from_plan.scale();
    placement.origin.heading_rad = std::atan2(m(1, 0), m(0, 0));
    const Point<World> at{unit_m * corner.x, unit_m * corner.y};
    if (std::hypot(at.x, at.y) <= kLocal_m) placement.origin.position = at;
    return placement;
}

GroundRaster asItIs(Dataset dataset, const Georeference& where,
                    const std::optional<OnGlobe>& globe) {
    const int height = dataset->GetRasterYSize();
    const double unit_m = where.system.IsEmpty() ? 1.0 : where.system.GetLinearUnits();
    const Point<Plan> middle = middleOf(*dataset);
    GroundRaster raster{std::move(dataset), placementOf(where.ground_from_plan, height, unit_m)};
    if (globe) {
        raster.geo_tie = GeoTie{worldFromPlan(raster.placement, height) * middle, globe->at,
                                globe->bearing_of_y_rad};
    }
    return raster;
}

tl::unexpected<Error> badPlace(const std::string& path, const char* why) {
    return fail(ErrorCode::kBadValue, path, why);
}

}  // namespace

OGRSpatialReference globeInDegrees() {
    OGRSpatialReference globe;
    globe.SetWellKnownGeogCS("WGS84");
    globe.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return globe;
}

Projection toGlobe(const OGRSpatialReference& system) {
    const OGRSpatialReference globe = globeInDegrees();
    return Projection(OGRCreateCoordinateTransformation(&system, &globe));
}

std::optional<LatLon> latLon(OGRCoordinateTransformation& globe_from_ground, Point<Ground> p) {
    if (!globe_from_ground.Transform(1, &p.x, &p.y)) return std::nullopt;
    const bool on_globe = std::abs(p.y) <= 90.0 && std::abs(p.x) <= 360.0;
    return on_globe ? std::optional(LatLon{p.y, p.x}) : std::nullopt;
}

Result<std::optional<Georeference>> georeferenceOf(GDALDataset& dataset, const std::string& path) {
    Affine a{};
    if (dataset.GetGeoTransform(a.data()) != CE_None) return std::nullopt;
    Eigen::Matrix2d linear;
    linear << a[1], a[2], a[4], a[5];
    const Eigen::Vector2d corner(a[0], a[3]);
    if (!corner.allFinite() || !linear.allFinite()) {
        return badPlace(path, "its georeference is not finite");
    }
    if (linear.determinant() == 0.0) return badPlace(path, "its georeference has a zero scale");
    Georeference found{{linear, corner}};
    if (const OGRSpatialReference* system = dataset.GetSpatialRef()) found.system = *system;
    found.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return found;
}

Result<GroundRaster> onGround(Dataset dataset, const Georeference& where, const std::string& path) {
    const GdalReason reason;
    Georeference from = where;
    if (from.system.IsEmpty() && from.ground_from_plan.scale() < kSmallestPixel) {
        from.system = globeInDegrees();
    }
    const Point<Ground> middle = from.ground_from_plan * middleOf(*dataset);
    const auto globe = from.system.IsEmpty() ? std::nullopt : onGlobe(from.system, middle);
    if (from.system.IsGeographic() && !globe) {
        return badPlace(path, "its georeference lies outside of the globe");
    }
    const double unit_m = from.system.IsProjected() ? from.system.GetLinearUnits() : 1.0;
    const bool metric = !from.system.IsGeographic() &&
                        (!globe || std::abs(globe->scale * unit_m - 1.0) <= kTrueScale);
    if (metric && isSimilarity(from.ground_from_plan.linear())) {
        return asItIs(std::move(dataset), from, globe);
    }
    const OGRSpatialReference target = metric ? from.system : localMetres(globe->at);
    const Dataset source = withGeoreference(*dataset, from);
    Dataset view = source ? warped(*source, target) : nullptr;
    if (!view) return notAnImage(path, reason);
    const auto again = georeferenceOf(*view, path);
    if (!again) return tl::make_unexpected(again.error());
    if (!*again) return badPlace(path, "its georeference cannot be used");
    const Georeference upright{(*again)->ground_from_plan, target};
    const auto place = target.IsEmpty()
                           ? std::nullopt
                           : onGlobe(target, upright.ground_from_plan * middleOf(*view));
    return asItIs(std::move(view), upright, place);
}

}  // namespace hedr
