#include "core/site/map_system.h"

#include <cmath>
#include <memory>

#include "core/site/raster/georeference.h"
#include "core/text/number.h"

namespace hedr {
namespace {

constexpr std::size_t kLongestBytes = 64 << 10;
constexpr std::string_view kByNumber = "EPSG:";

OGRSpatialReference systemOf(const std::string& text) {
    OGRSpatialReference system;
    if (text.size() > kLongestBytes) return system;
    if (text.starts_with(kByNumber)) {
        const double number = parseNumber(text.substr(kByNumber.size())).value_or(0.0);
        if (number >= 1.0 && number < 1e6) system.importFromEPSG(static_cast<int>(number));
    } else {
        system.importFromWkt(text.c_str());
    }
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

}  // namespace

Result<std::optional<GlobeFinder>> globeFinder(const std::string& system_text,
                                               const std::string& where) {
    const GdalReason reason;
    const OGRSpatialReference system = systemOf(system_text);
    if (!system.IsProjected() && !system.IsLocal()) {
        return fail(ErrorCode::kBadValue, where, "its reference system (#CRS) is not known");
    }
    if (std::abs(system.GetLinearUnits() - 1.0) > 1e-9) {
        return fail(ErrorCode::kBadValue, where, "its reference system (#CRS) is not in metres");
    }
    if (system.IsLocal()) return std::nullopt;
    const std::shared_ptr<OGRCoordinateTransformation> globe_from_ground = toGlobe(system);
    if (!globe_from_ground) {
        return fail(ErrorCode::kBadValue, where,
                    "its reference system (#CRS) has no known place on the globe");
    }
    return GlobeFinder([globe_from_ground](Point<Ground> p) {
        const GdalReason quiet;
        return latLon(*globe_from_ground, p);
    });
}

}  // namespace hedr
