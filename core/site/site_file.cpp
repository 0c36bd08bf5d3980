#include "core/site/site_file.h"

#include <array>
#include <span>
#include <utility>

#include "core/site/portable_path.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"
#include "core/text/text_file.h"
#include "core/text/toml_lines.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr int kPointsPerLine = 6;

std::string listOf(std::span<const double> numbers) {
    std::string list;
    for (const double number : numbers) list += (list.empty() ? "[" : ", ") + tomlNumber(number);
    return list + ']';
}

template <class Frame>
std::string listOf(const std::vector<Point<Frame>>& points) {
    std::string list = "[";
    int in_line = 0;
    for (const Point<Frame>& p : points) {
        list += in_line == 0 ? "\n    " : " ";
        list += listOf(std::array{p.x, p.y}) + ',';
        in_line = (in_line + 1) % kPointsPerLine;
    }
    return list + (points.empty() ? "]" : "\n]");
}

void addStraightening(TomlLines& lines, const Straightening& straightening) {
    std::vector<double> numbers;
    for (const Point<Plan>& corner : straightening.quad.corners) {
        numbers.insert(numbers.end(), {corner.x, corner.y});
    }
    lines.add("straightened_px", listOf(numbers));
    if (straightening.aspect) lines.add("straightened_aspect", *straightening.aspect);
}

void addPlacingPoints(TomlLines& lines, const PlacingPoints& placed_by) {
    std::vector<Point<Plan>> on_plan;
    std::vector<Point<World>> in_world;
    std::string names;
    for (const ControlPoint& point : placed_by.points) {
        on_plan.push_back(point.plan);
        in_world.push_back(point.world);
        names += (names.empty() ? "" : ", ") + quotedToml(point.name);
    }
    lines.add("points_px", listOf(on_plan));
    lines.add("points_m", listOf(in_world));
    lines.add("point_names", '[' + names + ']');
    if (placed_by.keep_scale) lines.addBool("points_keep_scale", true);
    if (placed_by.keep_rotation) lines.addBool("points_keep_rotation", true);
}

void addPlan(TomlLines& lines, const SitePlan& plan, const fs::path& base_folder) {
    lines.beginTable("[[floor.plan]]");
    lines.addText("image", portablePath(plan.image_file, base_folder).generic_string());
    if (plan.page != 1) lines.add("page", std::to_string(plan.page));
    if (plan.straightened) addStraightening(lines, *plan.straightened);
    if (!plan.sha256.empty()) lines.addText("sha256", plan.sha256);
    lines.add("resolution_m", plan.placement.resolution_m);
    lines.add("origin_x_m", plan.placement.origin.position.x);
    lines.add("origin_y_m", plan.placement.origin.position.y);
    lines.add("rotation_rad", plan.placement.origin.heading_rad);
    if (!plan.placed_by.points.empty()) addPlacingPoints(lines, plan.placed_by);
    lines.add("opacity", plan.opacity);
    lines.addBool("visible", plan.visible);
    lines.addBool("locked", plan.locked);
    lines.addBool("inverted_at_night", plan.inverted_at_night);
    if (plan.tells_direction) lines.addBool("tells_direction", true);
    if (const auto& crop = plan.crop)
        lines.add("crop_px",
                  listOf(std::array{crop->min.x, crop->min.y, crop->max.x, crop->max.y}));
}

void addStroke(TomlLines& lines, const WallStroke& stroke) {
    lines.beginTable("[[floor.stroke]]");
    lines.addText("pen", stroke.pen == WallPen::kWall ? "wall" : "eraser");
    lines.add("width_m", stroke.width_m);
    lines.add("points_m", listOf(stroke.points));
}

void addGeoTie(TomlLines& lines, const GeoTie& tie) {
    lines.beginTable("[geo_tie]");
    lines.add("x_m", tie.point.x);
    lines.add("y_m", tie.point.y);
    lines.add("latitude_deg", tie.at.latitude_deg);
    lines.add("longitude_deg", tie.at.longitude_deg);
    lines.add("bearing_of_y_rad", tie.bearing_of_y_rad);
}

fs::path folderOf(const fs::path& file) { return fs::absolute(file).parent_path(); }

}  // namespace

std::string siteText(const Site& site, const fs::path& base_folder) {
    TomlLines lines;
    lines.add("site", "1");
    if (site.direction_rad) lines.add("direction_rad", *site.direction_rad);
    if (site.geo_tie) addGeoTie(lines, *site.geo_tie);
    for (const SiteFloor& floor : site.floors) {
        lines.beginTable("[[floor]]");
        lines.addText("name", floor.name);
        for (const SitePlan& plan : floor.plans) addPlan(lines, plan, base_folder);
        for (const WallStroke& stroke : floor.wall_strokes) addStroke(lines, stroke);
    }
    return std::move(lines).take();
}

Result<Site> readSite(const fs::path& file) {
    return readTextFile(file).and_then([&file](const std::string& text) {
        return parseSite(text, file.string(), folderOf(file));
    });
}

Result<void> writeSite(const Site& site, const fs::path& file) {
    const std::string text = siteText(site, folderOf(file));
    if (const auto readable = parseSite(text, file.string(), folderOf(file)); !readable)
        return tl::make_unexpected(readable.error());
    return writeTextFile(file, text);
}

}  // namespace hedr
