#include "core/site/geo_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "core/text/number.h"

namespace hedr {
namespace {

// One of the two numbers of a place.
struct Angle {
    double deg = 0.0;
    char letter = 0;  // N, S, E, W; 0: none
};

constexpr std::string_view kLetters = "NSEW";

// Each `sign` in a text as something else.
std::string withAll(const std::string& text, std::string_view sign, std::string_view instead) {
    std::string changed;
    std::size_t from = 0;
    for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign, from)) {
        changed.append(text, from, at - from).append(instead);
        from = at + sign.size();
    }
    return changed.append(text, from, std::string::npos);
}

std::string inQuotes(std::string_view text) {
    std::string quoted(1, '"');
    return quoted.append(text).append(1, '"');
}

// Signs of degrees, minutes and seconds only separate numbers here; letters are made capital.
std::string plainSigns(std::string_view text) {
    constexpr std::array kSigns{std::string_view("°"), std::string_view("′"), std::string_view("″"),
                                std::string_view("’"), std::string_view("”"), std::string_view("'"),
                                std::string_view("\"")};
    std::string plain = withAll(std::string(text), "−", "-");
    for (const std::string_view sign : kSigns) plain = withAll(plain, sign, " ");
    for (char& c : plain) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
        if (c == '\t') c = ' ';
    }
    return plain;
}

std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> found;
    for (std::size_t at = 0; (at = text.find_first_not_of(' ', at)) != std::string::npos;) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        found.push_back(text.substr(at, end - at));
        at = end;
    }
    return found;
}

std::pair<std::string, std::string> cut(const std::string& text, std::size_t at, std::size_t skip) {
    return {text.substr(0, at), text.substr(at + skip)};
}

// Where latitude and longitude part: by letters, by a semicolon, by a comma, by the middle space.
std::optional<std::pair<std::string, std::string>> halves(const std::string& text) {
    const std::size_t first = text.find_first_of(kLetters);
    if (first != std::string::npos) {
        const std::size_t second = text.find_first_of(kLetters, first + 1);
        if (second == std::string::npos) return std::nullopt;
        const bool in_front = text.find_first_not_of(' ') == first;
        return in_front ? cut(text, second, 0) : cut(text, first + 1, 0);
    }
    for (const std::string_view separator : {";", ", "}) {
        const std::size_t at = text.find(separator);
        if (at != std::string::npos) return cut(text, at, separator.size());
    }
    const auto commas = std::ranges::count(text, ',');
    if (commas == 1) return cut(text, text.find(','), 1);
    if (commas > 1) return std::nullopt;
    const std::vector<std::string> numbers = words(text);
    if (numbers.size() != 2) return std::nullopt;
    return std::pair(numbers[0], numbers[1]);
}

std::optional<Angle> angleOf(std::string half) {
    Angle angle;
    for (char& c : half) {
        if (kLetters.find(c) != std::string_view::npos) {
            if (angle.letter != 0) return std::nullopt;
            angle.letter = std::exchange(c, ' ');
        }
        if (c == ';') c = ' ';
        if (c == ',') c = '.';
    }
    std::vector<std::string> parts = words(half);
    if (!parts.empty() && parts.back() == ".") parts.pop_back();  // the comma between two halves
    if (!parts.empty() && parts.front() == ".") parts.erase(parts.begin());
    if (parts.empty() || parts.size() > 3) return std::nullopt;
    double unit = 1.0;
    bool fraction = false;  // only the last part may have one
    for (const std::string& part : parts) {
        const auto number =
            parseNumber(part.ends_with('.') ? part.substr(0, part.size() - 1) : part);
        const bool first = unit == 1.0;
        if (!number || !std::isfinite(*number) || fraction) return std::nullopt;
        fraction = *number != std::floor(*number);
        if (!first && !(*number >= 0.0 && *number < 60.0)) return std::nullopt;
        angle.deg = first ? *number : angle.deg + std::copysign(*number * unit, angle.deg);
        unit /= 60.0;
    }
    if (angle.letter != 0 && std::signbit(angle.deg)) return std::nullopt;  // south twice
    if (angle.letter == 'S' || angle.letter == 'W') angle.deg = -angle.deg;
    return angle;
}

std::optional<double> metresOf(std::string half) {
    std::ranges::replace(half, ',', '.');
    std::vector<std::string> parts = words(half);
    if (parts.size() == 2 && parts.back() == "M") parts.pop_back();
    const auto number = parts.size() == 1 ? parseNumber(parts.front()) : std::nullopt;
    constexpr double kFarthest_m = 1e7;
    return number && std::abs(*number) <= kFarthest_m ? number : std::nullopt;
}

bool isNorthSouth(const Angle& angle) { return angle.letter == 'N' || angle.letter == 'S'; }
bool isEastWest(const Angle& angle) { return angle.letter == 'E' || angle.letter == 'W'; }

}  // namespace

Result<LatLon> latLonFromText(std::string_view text) {
    const auto refuse = [&] {
        return fail(ErrorCode::kBadValue, inQuotes(text),
                    "must be latitude and longitude, as in 52.2197, 21.0122");
    };
    constexpr std::size_t kLongest = 100;
    if (text.size() > kLongest) return refuse();
    const auto parts = halves(plainSigns(text));
    if (!parts) return refuse();
    auto a = angleOf(parts->first);
    auto b = angleOf(parts->second);
    if (!a || !b) return refuse();
    if (isEastWest(*a) && isNorthSouth(*b)) std::swap(a, b);
    if (isEastWest(*a) || isNorthSouth(*b)) return refuse();
    if (!(std::abs(a->deg) <= 90.0) || !(std::abs(b->deg) <= 180.0)) return refuse();
    return LatLon{a->deg, b->deg};
}

Result<Point<World>> worldPointFromText(std::string_view text, const std::optional<GeoTie>& tie) {
    const std::string plain = plainSigns(text);
    const bool metres = text.find("°") == std::string_view::npos &&
                        plain.find_first_of(kLetters) == std::string::npos;
    const auto at = latLonFromText(text);
    if (!metres && at) {
        if (tie) return worldPointOf(*at, *tie);
        return fail(ErrorCode::kNoData, std::string(text), "the map is not tied to the globe");
    }
    const auto parts = halves(plain);
    const auto x = parts ? metresOf(parts->first) : std::nullopt;
    const auto y = parts ? metresOf(parts->second) : std::nullopt;
    if (!x || !y) {
        return fail(ErrorCode::kBadValue, inQuotes(text),
                    "must be metres, as in 12.5, 3.2, or latitude and longitude, as in 52.2197 N, "
                    "21.0122 E");
    }
    return Point<World>{*x, *y};
}

std::string latLonText(LatLon at) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.7f, %.7f", at.latitude_deg, at.longitude_deg);
    return text.data();
}

}  // namespace hedr
