#include "core/site/control_points_file.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/site/map_system.h"
#include "core/text/csv.h"
#include "core/text/number.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

// Where a format keeps what.
struct Layout {
    std::array<std::size_t, 2> plan{};
    std::array<std::size_t, 2> place{};  // x, y or latitude, longitude
    bool geographic = false;
    double plan_y_sign = 1.0;
    std::optional<std::size_t> name{};
    std::optional<std::size_t> enable{};
    std::optional<GlobeFinder> find_on_globe{};  // where x, y are to become latitude, longitude
};

using Columns = std::array<std::size_t, 2>;

Result<Columns> columns(const CsvReader& csv, const char* first, const char* second) {
    const auto a = csv.require(first);
    if (!a) return tl::make_unexpected(a.error());
    const auto b = csv.require(second);
    if (!b) return tl::make_unexpected(b.error());
    return Columns{*a, *b};
}

Result<Layout> ownLayout(const CsvReader& csv) {
    Layout layout;
    const auto plan = columns(csv, "plan_x_px", "plan_y_px");
    if (!plan) return tl::make_unexpected(plan.error());
    layout.plan = *plan;
    layout.geographic = csv.find("latitude_deg").has_value();
    if (layout.geographic && csv.find("world_x_m")) {
        return fail(ErrorCode::kBadFormat, csv.where(),
                    "give world_x_m and world_y_m, or latitude_deg and longitude_deg, not both");
    }
    const auto place = layout.geographic ? columns(csv, "latitude_deg", "longitude_deg")
                                         : columns(csv, "world_x_m", "world_y_m");
    if (!place) return tl::make_unexpected(place.error());
    layout.place = *place;
    layout.name = csv.find("name");
    return layout;
}

// QGIS says in a comment which reference system the coordinates have; empty without one.
std::string_view systemIn(std::string_view text) {
    text = withoutByteOrderMark(text);
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!line.starts_with("#CRS:")) return {};
    const std::size_t begin = line.find_first_not_of(" \r", 5);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(" \r") + 1 - begin);
}

// Degrees need other columns than metres.
bool saysDegrees(std::string_view system) {
    for (const char* start : {"GEOGCRS[", "GEOGCS[", "GEODCRS[", "EPSG:4326", "OGC:CRS84"}) {
        if (system.starts_with(start)) return true;
    }
    return false;
}

Result<Layout> qgisLayout(const CsvReader& csv, std::string_view system, const std::string& path) {
    Layout layout;
    const bool degrees = saysDegrees(system);
    layout.geographic = degrees;
    layout.plan_y_sign = -1.0;  // QGIS counts the rows of an image downwards as negative
    const auto plan =
        csv.find("pixelX") ? columns(csv, "pixelX", "pixelY") : columns(csv, "sourceX", "sourceY");
    if (!plan) return tl::make_unexpected(plan.error());
    layout.plan = *plan;
    const auto place = degrees ? columns(csv, "mapY", "mapX") : columns(csv, "mapX", "mapY");
    if (!place) return tl::make_unexpected(place.error());
    layout.place = *place;
    layout.enable = csv.find("enable");
    if (degrees || system.empty()) return layout;
    auto finder = globeFinder(std::string(system), path + ":1");
    if (!finder) return tl::make_unexpected(finder.error());
    layout.find_on_globe = std::move(*finder);
    layout.geographic = layout.find_on_globe.has_value();
    return layout;
}

struct Row {
    std::string name;
    Point<Plan> plan;
    std::array<double, 2> place;
};

Result<Row> readRow(const CsvReader& csv, const Layout& layout) {
    std::array<double, 4> values{};
    const std::array from = {layout.plan[0], layout.plan[1], layout.place[0], layout.place[1]};
    for (std::size_t i = 0; i < from.size(); ++i) {
        const auto value = csv.number(from[i]);
        if (!value) return tl::make_unexpected(value.error());
        values[i] = *value;
    }
    if (layout.find_on_globe) {
        const auto at = (*layout.find_on_globe)({values[2], values[3]});
        if (!at) return fail(ErrorCode::kBadValue, csv.where(), "this place is not on the globe");
        values[2] = at->latitude_deg;
        values[3] = at->longitude_deg;
    }
    if (layout.geographic && (std::abs(values[2]) > 90.0 || std::abs(values[3]) > 180.0)) {
        return fail(ErrorCode::kBadValue, csv.where(),
                    "latitude must be within 90 degrees, longitude within 180");
    }
    const std::string name(layout.name ? csv.text(*layout.name) : std::string_view{});
    // + 0.0 makes a zero of a negative one.
    return Row{name, {values[0], layout.plan_y_sign * values[1] + 0.0}, {values[2], values[3]}};
}

Result<bool> isEnabled(const CsvReader& csv, const Layout& layout) {
    if (!layout.enable) return true;
    const auto value = csv.number(*layout.enable);
    if (!value) return tl::make_unexpected(value.error());
    return *value != 0.0;
}

Result<std::vector<Row>> readRows(CsvReader& csv, const Layout& layout) {
    std::vector<Row> rows;
    for (;;) {
        const auto more = csv.next();
        if (!more) return tl::make_unexpected(more.error());
        if (!*more) return rows;
        const auto enabled = isEnabled(csv, layout);
        if (!enabled) return tl::make_unexpected(enabled.error());
        if (!*enabled) continue;
        auto row = readRow(csv, layout);
        if (!row) return tl::make_unexpected(row.error());
        rows.push_back(std::move(*row));
    }
}

ControlPoints fromRows(const std::vector<Row>& rows, bool geographic) {
    if (geographic) {
        std::vector<GeoControlPoint> points;
        points.reserve(rows.size());
        for (const Row& r : rows) points.push_back({r.name, r.plan, {r.place[0], r.place[1]}});
        return points;
    }
    std::vector<ControlPoint> points;
    points.reserve(rows.size());
    for (const Row& r : rows) points.push_back({r.name, r.plan, {r.place[0], r.place[1]}});
    return points;
}

// The reader knows no quotes: a name must not hold what ends a field or a line.
std::string fieldOf(const std::string& name) {
    std::string field = name;
    for (char& c : field) {
        if (c == ',') c = ';';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    }
    return field;
}

void appendRow(std::string& text, const std::array<double, 4>& values, const std::string& name) {
    for (const double value : values) {
        appendNumber(text, value);
        text += ',';
    }
    text += fieldOf(name) + '\n';
}

}  // namespace

Result<ControlPoints> parseControlPoints(std::string_view text, const std::string& path) {
    auto csv = CsvReader::open(text, path);
    if (!csv) return tl::make_unexpected(csv.error());
    const bool qgis = csv->find("mapX").has_value();
    const auto layout = qgis ? qgisLayout(*csv, systemIn(text), path) : ownLayout(*csv);
    if (!layout) return tl::make_unexpected(layout.error());
    const auto rows = readRows(*csv, *layout);
    if (!rows) return tl::make_unexpected(rows.error());
    return fromRows(*rows, layout->geographic);
}

Result<ControlPoints> loadControlPoints(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&](const std::string& text) { return parseControlPoints(text, file.string()); });
}

Result<void> saveControlPoints(const ControlPoints& points, const std::filesystem::path& csv_file) {
    std::string text;
    if (const auto* metric = std::get_if<std::vector<ControlPoint>>(&points)) {
        text = "plan_x_px,plan_y_px,world_x_m,world_y_m,name\n";
        for (const auto& p : *metric) {
            appendRow(text, {p.plan.x, p.plan.y, p.world.x, p.world.y}, p.name);
        }
    } else {
        text = "plan_x_px,plan_y_px,latitude_deg,longitude_deg,name\n";
        for (const auto& p : std::get<std::vector<GeoControlPoint>>(points)) {
            appendRow(text, {p.plan.x, p.plan.y, p.at.latitude_deg, p.at.longitude_deg}, p.name);
        }
    }
    return writeTextFile(csv_file, text);
}

}  // namespace hedr
