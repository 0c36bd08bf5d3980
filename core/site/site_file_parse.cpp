#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/site/site_file.h"
#include "core/text/toml.h"
#include "core/text/toml_keys.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

// In bytes; parsing takes up to 40 times as many.
constexpr std::size_t kLongestSite = std::size_t{16} << 20;
constexpr std::size_t kSha256Digits = 64;
constexpr std::int64_t kMostPages = 1000000;
constexpr std::int64_t kFormat = 1;

bool isAny(double) { return true; }
bool isPositive(double value) { return value > 0.0; }
bool isShare(double value) { return value >= 0.0 && value <= 1.0; }
bool isLatitude(double value) { return std::abs(value) <= 90.0; }
bool isLongitude(double value) { return std::abs(value) <= 180.0; }

constexpr NumberRule kAny{isAny, "must be a finite number"};
constexpr NumberRule kPositive{isPositive, "must be positive"};
constexpr NumberRule kShare{isShare, "must be from 0 to 1"};
constexpr NumberRule kLatitude{isLatitude, "must be from -90 to 90"};
constexpr NumberRule kLongitude{isLongitude, "must be from -180 to 180"};

bool isHash(std::string_view text) {
    return text.size() == kSha256Digits &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::optional<PlanCrop> readCrop(TomlKeys& keys) {
    std::array<double, 4> sides{};
    if (!keys.numbers("crop_px", sides)) return std::nullopt;
    const PlanCrop crop{{sides[0], sides[1]}, {sides[2], sides[3]}};
    if (!(crop.min.x < crop.max.x && crop.min.y < crop.max.y))
        keys.refuse("crop_px", "must be [left, top, right, bottom]");
    return crop;
}

std::optional<Straightening> readStraightening(TomlKeys& keys) {
    std::array<double, 8> numbers{};
    const bool has_aspect = keys.has("straightened_aspect");
    Straightening straightening;
    if (has_aspect) straightening.aspect = keys.neededNumber("straightened_aspect", kPositive);
    if (!keys.numbers("straightened_px", numbers)) {
        if (has_aspect) keys.refuse("straightened_aspect", "is of no use without straightened_px");
        return std::nullopt;
    }
    for (std::size_t i = 0; i < straightening.quad.corners.size(); ++i) {
        straightening.quad.corners[i] = {numbers[2 * i], numbers[2 * i + 1]};
    }
    return straightening;
}

// Counted from 1.
int readPage(TomlKeys& keys) {
    if (!keys.has("page")) return 1;
    const std::int64_t page = keys.neededInteger("page");
    if (page >= 1 && page <= kMostPages) return static_cast<int>(page);
    keys.refuse("page", "must be from 1 to " + std::to_string(kMostPages));
    return 1;
}

PlacingPoints readPlacingPoints(TomlKeys& keys) {
    PlacingPoints placed_by;
    placed_by.keep_scale = keys.flag("points_keep_scale", false);
    placed_by.keep_rotation = keys.flag("points_keep_rotation", false);
    const std::vector<std::string> names = keys.texts("point_names");
    if (!keys.has("points_px") && !keys.has("points_m")) return placed_by;
    const auto on_plan = keys.neededPairs("points_px");
    const auto in_world = keys.neededPairs("points_m");
    if (on_plan.size() != in_world.size() || (!names.empty() && names.size() != on_plan.size())) {
        keys.refuse("points_m", "must hold as many as points_px and point_names");
        return placed_by;
    }
    for (std::size_t i = 0; i < on_plan.size(); ++i) {
        placed_by.points.push_back({names.empty() ? "" : names[i],
                                    {on_plan[i].first, on_plan[i].second},
                                    {in_world[i].first, in_world[i].second}});
    }
    return placed_by;
}

SitePlan readPlan(TomlKeys keys, const fs::path& base_folder) {
    SitePlan plan;
    const std::string image = keys.neededText("image");
    if (image.empty()) keys.refuse("image", "must be the name of a file");
    plan.image_file = (base_folder / image).lexically_normal();
    plan.page = readPage(keys);
    plan.straightened = readStraightening(keys);
    plan.sha256 = keys.text("sha256", "");
    if (!plan.sha256.empty() && !isHash(plan.sha256))
        keys.refuse("sha256", "must have 64 hexadecimal digits");
    plan.placement.resolution_m = keys.neededNumber("resolution_m", kPositive);
    Pose<World>& origin = plan.placement.origin;
    origin.position.x = keys.number("origin_x_m", 0.0, kAny);
    origin.position.y = keys.number("origin_y_m", 0.0, kAny);
    origin.heading_rad = keys.number("rotation_rad", 0.0, kAny);
    plan.placed_by = readPlacingPoints(keys);
    plan.opacity = keys.number("opacity", plan.opacity, kShare);
    plan.visible = keys.flag("visible", plan.visible);
    plan.locked = keys.flag("locked", plan.locked);
    plan.inverted_at_night = keys.flag("inverted_at_night", plan.inverted_at_night);
    plan.crop = readCrop(keys);
    plan.tells_direction = keys.flag("tells_direction", false);
    keys.refuseOthers();
    return plan;
}

WallStroke readStroke(TomlKeys keys) {
    WallStroke stroke;
    const std::string pen = keys.neededText("pen");
    if (pen != "wall" && pen != "eraser") keys.refuse("pen", "must be \"wall\" or \"eraser\"");
    stroke.pen = pen == "eraser" ? WallPen::kEraser : WallPen::kWall;
    stroke.width_m = keys.neededNumber("width_m", kPositive);
    for (const auto& [x, y] : keys.neededPairs("points_m")) stroke.points.push_back({x, y});
    keys.refuseOthers();
    return stroke;
}

GeoTie readGeoTie(TomlKeys keys) {
    GeoTie tie;
    tie.point.x = keys.number("x_m", 0.0, kAny);
    tie.point.y = keys.number("y_m", 0.0, kAny);
    tie.at.latitude_deg = keys.neededNumber("latitude_deg", kLatitude);
    tie.at.longitude_deg = keys.neededNumber("longitude_deg", kLongitude);
    tie.bearing_of_y_rad = keys.number("bearing_of_y_rad", 0.0, kAny);
    keys.refuseOthers();
    return tie;
}

SiteFloor readFloor(TomlKeys keys, const fs::path& base_folder) {
    SiteFloor floor;
    floor.name = keys.neededText("name");
    for (const TomlKeys& plan : keys.tables("plan"))
        floor.plans.push_back(readPlan(plan, base_folder));
    for (const TomlKeys& stroke : keys.tables("stroke"))
        floor.wall_strokes.push_back(readStroke(stroke));
    keys.refuseOthers();
    return floor;
}

Site readWhole(TomlKeys keys, const fs::path& base_folder) {
    Site site;
    if (keys.neededInteger("site") != kFormat)
        keys.refuse("site", "must be 1, the only format that this version reads");
    if (keys.has("direction_rad")) site.direction_rad = keys.neededNumber("direction_rad", kAny);
    if (const auto tie = keys.table("geo_tie")) site.geo_tie = readGeoTie(*tie);
    for (const TomlKeys& floor : keys.tables("floor"))
        site.floors.push_back(readFloor(floor, base_folder));
    keys.refuseOthers();
    return site;
}

}  // namespace

Result<Site> parseSite(std::string_view text, const std::string& name,
                       const fs::path& base_folder) {
    if (text.size() > kLongestSite)
        return fail(ErrorCode::kBadFormat, name,
                    "it has " + std::to_string(text.size()) + " bytes, a site has " +
                        std::to_string(kLongestSite) + " at most");
    const auto table = parseToml(text, name);
    if (!table) return tl::make_unexpected(table.error());
    FirstError error(name);
    Site site = readWhole(TomlKeys(*table, error), base_folder);
    if (error.found()) return tl::make_unexpected(*error.found());
    return site;
}

}  // namespace hedr
