#include "core/site/world_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/text/number.h"

namespace hedr {
namespace {

constexpr std::size_t kNumbers = 6;
constexpr double kMostShear = 1e-3;  // of a pixel's side; what rounded numbers may make of a square

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

Result<double> parseLine(std::string_view line, const std::string& where) {
    const auto number = parseNumber(trimmed(line));
    if (!number) return fail(ErrorCode::kBadFormat, where, "expected a number");
    if (!std::isfinite(*number)) return fail(ErrorCode::kBadValue, where, "must be finite");
    return *number;
}

Result<std::array<double, kNumbers>> parseNumbers(std::string_view text, const std::string& path) {
    std::array<double, kNumbers> numbers{};
    std::size_t count = 0;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view content = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (content.empty()) continue;
        const std::string where = path + ':' + std::to_string(line);
        if (count == kNumbers) {
            return fail(ErrorCode::kBadFormat, where, "a world file has six numbers");
        }
        const auto number = parseLine(content, where);
        if (!number) return tl::make_unexpected(number.error());
        numbers[count++] = *number;
    }
    if (count == kNumbers) return numbers;
    return fail(ErrorCode::kBadFormat, path,
                "a world file has six numbers, this one " + std::to_string(count));
}

}  // namespace

Result<WorldFile> parseWorldFile(std::string_view text, const std::string& path) {
    const auto n = parseNumbers(text, path);
    if (!n) return tl::make_unexpected(n.error());
    const WorldFile file{n->at(0), n->at(1), n->at(2), n->at(3), n->at(4), n->at(5)};
    const double area = file.x_per_column * file.y_per_row - file.x_per_row * file.y_per_column;
    if (area != 0.0 && std::isfinite(area)) return file;
    return fail(ErrorCode::kBadValue, path, "its pixels have no size");
}

std::string worldFileText(const WorldFile& n) {
    std::string text;
    for (const double number :
         {n.x_per_column, n.y_per_column, n.x_per_row, n.y_per_row, n.first_x, n.first_y}) {
        appendNumber(text, number);
        text += '\n';
    }
    return text;
}

Transform<World, Plan> worldFromPlan(const WorldFile& n) {
    Eigen::Matrix2d linear;
    linear << n.x_per_column, n.x_per_row, n.y_per_column, n.y_per_row;
    // The numbers speak of a pixel's centre, plan pixels of its corner.
    const Eigen::Vector2d centre(n.first_x, n.first_y);
    return {linear, centre - linear * Eigen::Vector2d(0.5, 0.5)};
}

WorldFile worldFileOf(const Transform<World, Plan>& world_from_plan) {
    const Eigen::Matrix2d& linear = world_from_plan.linear();
    const Point<World> centre = world_from_plan * Point<Plan>{0.5, 0.5};
    return {linear(0, 0), linear(1, 0), linear(0, 1), linear(1, 1), centre.x, centre.y};
}

Result<PlanPlacement> placementOf(const WorldFile& n, int height_px, const std::string& path) {
    if (n.x_per_column * n.y_per_row - n.x_per_row * n.y_per_column > 0.0) {
        return fail(ErrorCode::kBadValue, path, "the image is mirrored");
    }
    const double resolution_m = std::hypot(n.x_per_column, n.y_per_column);
    // Of a square pixel, the step to the next row is that to the next column turned to the right.
    const double off = std::hypot(n.x_per_row - n.y_per_column, n.y_per_row + n.x_per_column);
    if (off > kMostShear * resolution_m) {
        return fail(ErrorCode::kBadValue, path, "its pixels are not square");
    }
    const Point<World> lower_left =
        worldFromPlan(n) * Point<Plan>{0.0, static_cast<double>(height_px)};
    return PlanPlacement{resolution_m, {lower_left, std::atan2(n.y_per_column, n.x_per_column)}};
}

}  // namespace hedr
