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
constexpr std::size_t kLongestBytes = 64 << 10;

struct Numbers {
    std::array<double, 6> values{};
    std::size_t count = 0;
};

// One number a line; some programs write a comma for the point, or all of them in one line.
Result<Numbers> readNumbers(std::string_view text, const std::string& path) {
    Numbers numbers;
    std::size_t line = 1;
    while (numbers.count < numbers.values.size()) {
        const std::size_t begin = text.find_first_not_of(kBlank);
        if (begin == std::string_view::npos) break;
        for (const char c : text.substr(0, begin)) line += c == '\n' ? 1 : 0;
        text.remove_prefix(begin);
        std::string word(text.substr(0, text.find_first_of(kBlank)));
        text.remove_prefix(word.size());
        if (const std::size_t comma = word.find(','); comma != std::string::npos) word[comma] = '.';
        const auto value = parseNumber(word.starts_with('+') ? word.substr(1) : word);
        const std::string where = path + ':' + std::to_string(line);
        if (!value) return fail(ErrorCode::kBadFormat, where, "a world file has six numbers");
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

Result<Transform<Ground, Plan>> parseWorldFile(std::string_view text, const std::string& path) {
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
    const auto [a, d, b, e, c, f] = numbers->values;
    Eigen::Matrix2d linear;
    linear << a, b, d, e;
    const double area = linear.determinant();
    if (!std::isfinite(area) || area == 0.0) {
        return fail(ErrorCode::kBadValue, path, "a pixel has no size: the scale is zero");
    }
    const Eigen::Vector2d corner = Eigen::Vector2d(c, f) - linear * Eigen::Vector2d(0.5, 0.5);
    if (!corner.allFinite()) return fail(ErrorCode::kBadValue, path, "a number is not finite");
    return Transform<Ground, Plan>(linear, corner);
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

Result<Transform<Ground, Plan>> loadWorldFile(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&](const std::string& text) { return parseWorldFile(text, file.string()); });
}

}  // namespace hedr
