#include "core/site/world_file.h"

#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "core/text/number.h"
#include "core/text/text_file.h"

namespace hedr {
namespace {

constexpr std::string_view kBlank = " \t\r\n";
constexpr double kMostShear = 1e-3;  // of a pixel's side; what rounded numbers may make of a square
constexpr std::size_t kLongestBytes = 64 << 10;

struct Numbers {
    std::array<double, 6> values{};
    std::size_t count = 0;
};

// One number a line; some programs write a comma for the point, or all of them in one line.
Result<Numbers> readNumbers(std::string_view text, const std::string& path) {
    Numbers numbers;
    std::size_t line = 1;
    for (;;) {
        const std::size_t begin = text.find_first_not_of(kBlank);
        if (begin == std::string_view::npos) break;
        for (const char c : text.substr(0, begin)) line += c == '\n' ? 1 : 0;
        text.remove_prefix(begin);
        std::string word(text.substr(0, text.find_first_of(kBlank)));
        text.remove_prefix(word.size());
        if (const std::size_t comma = word.find(','); comma != std::string::npos) word[comma] = '.';
        const auto value = parseNumber(word.starts_with('+') ? word.substr(1) : word);
        const std::string where = path + ':' + std::to_string(line);
        if (!value || numbers.count == numbers.values.size()) {
            return fail(ErrorCode::kBadFormat, where, "a world file has six numbers");
        }
        if (!std::isfinite(*value)) {
            return fail(ErrorCode::kBadValue, where, "a number is not finite");
        }
        numbers.values[numbers.count++] = *value;
    }
    return numbers;
}

std::string inCapitals(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace

Result<WorldFile> parseWorldFile(std::string_view text, const std::string& path) {
    text = withoutByteOrderMark(text);
    if (text.find_first_not_of(kBlank) == std::string_view::npos) {
        return fail(ErrorCode::kFileEmpty, path);
    }
    if (text.size() > kLongestBytes) {
        return fail(ErrorCode::kBadFormat, path, "a world file has six numbers");
    }
    const auto numbers = readNumbers(text, path);
    if (!numbers) return tl::make_unexpected(numbers.error());
    if (numbers->count < numbers->values.size()) {
        return fail(ErrorCode::kBadFormat, path,
                    "a world file has six numbers, this one " + std::to_string(numbers->count));
    }
    const auto& n = numbers->values;
    const WorldFile file{n[0], n[1], n[2], n[3], n[4], n[5]};
    const double area = file.x_per_column * file.y_per_row - file.x_per_row * file.y_per_column;
    if (!std::isfinite(area) || area == 0.0) {
        return fail(ErrorCode::kBadValue, path, "a pixel has no size: the scale is zero");
    }
    return file;
}

std::optional<std::filesystem::path> worldFileBeside(const std::filesystem::path& image) {
    const std::string kind = image.extension().string();  // ".png"
    std::vector<std::string> endings{".wld"};
    if (kind.size() >= 3) {
        endings.insert(endings.begin(), {std::string{'.', kind[1], kind.back(), 'w'}, kind + 'w'});
    }
    for (const std::string& ending : endings) {
        for (const std::string& spelt : {ending, inCapitals(ending)}) {
            auto file = image;
            file.replace_extension(spelt);
            std::error_code ignored;
            if (std::filesystem::is_regular_file(file, ignored)) return file;
        }
    }
    return std::nullopt;
}

Result<WorldFile> loadWorldFile(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&](const std::string& text) { return parseWorldFile(text, file.string()); });
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

Transform<Ground, Plan> groundFromPlan(const WorldFile& n) {
    Eigen::Matrix2d linear;
    linear << n.x_per_column, n.x_per_row, n.y_per_column, n.y_per_row;
    // The numbers speak of a pixel's centre, plan pixels of its corner.
    const Eigen::Vector2d centre(n.first_x, n.first_y);
    return {linear, centre - linear * Eigen::Vector2d(0.5, 0.5)};
}

Transform<World, Plan> worldFromPlan(const WorldFile& n) {
    const Transform<Ground, Plan> ground = groundFromPlan(n);
    return {ground.linear(), ground.offset()};
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
