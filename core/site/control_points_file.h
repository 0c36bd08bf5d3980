#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.h"
#include "core/site/control_points.h"
#include "core/site/geo_tie.h"

namespace hedr {

// A place that is known both on a plan image and on the globe.
struct GeoControlPoint {
    std::string name;
    Point<Plan> plan{};
    LatLon at{};
    friend bool operator==(const GeoControlPoint&, const GeoControlPoint&) = default;
};

using ControlPoints = std::variant<std::vector<ControlPoint>, std::vector<GeoControlPoint>>;

// Reads POINTS.csv (plan_x_px, plan_y_px; world_x_m, world_y_m or latitude_deg, longitude_deg;
// name) or what QGIS saves as .points; README.md tells more. `path` stands in the errors:
// kFileEmpty, kMissingColumn, kBadFormat and kBadValue (path:line; a reference system too).
Result<ControlPoints> parseControlPoints(std::string_view text, const std::string& path);

// Errors: those of parseControlPoints, kFileMissing, kFileUnreadable, kFileTooLarge.
Result<ControlPoints> loadControlPoints(const std::filesystem::path& file);

// Writes our columns; commas in a name become semicolons. Errors: kFileUnwritable, kDiskFull.
Result<void> saveControlPoints(const ControlPoints& points, const std::filesystem::path& csv_file);

}  // namespace hedr
