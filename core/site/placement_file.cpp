#include "core/site/placement_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/geometry/angle.h"
#include "core/site/portable_path.h"
#include "core/text/number.h"
#include "core/text/plain_toml.h"
#include "core/text/text_file.h"
#include "core/text/toml.h"
#include "core/text/toml_length.h"
#include "core/text/trimmed.h"

namespace hedr {
namespace {

struct Value {
    std::string text;             // of a string
    std::vector<double> numbers;  // of a number or a list of numbers
    std::size_t line = 0;
};

// What both formats are reduced to.
struct Values {
    std::string path;
    std::map<std::string, Value, std::less<>> by_key;

    std::string where(const Value& value) const { return path + ':' + std::to_string(value.line); }

    Result<std::string> text(std::string_view key) const {
        const auto found = by_key.find(key);
        if (found == by_key.end()) return fail(ErrorCode::kMissingKey, path, std::string(key));
        if (!found->second.text.empty()) return found->second.text;
        return fail(ErrorCode::kBadValue, where(found->second),
                    std::string(key).append(" must be the name of a file"));
    }

    Result<std::vector<double>> numbers(std::string_view key, std::size_t count) const {
        const auto found = by_key.find(key);
        if (found == by_key.end()) return fail(ErrorCode::kMissingKey, path, std::string(key));
        bool good = found->second.numbers.size() == count;
        for (const double number : found->second.numbers) good = good && std::isfinite(number);
        if (good) return found->second.numbers;
        return fail(ErrorCode::kBadValue, where(found->second),
                    std::string(key) +
                        (count == 1 ? " must be a number"
                                    : " must be a list of " + std::to_string(count) + " numbers"));
    }

    Result<double> resolution(std::string_view key) const {
        const auto value = numbers(key, 1);
        if (!value) return tl::make_unexpected(value.error());
        if (value->front() > 0.0) return value->front();
        std::string detail = std::string(key) + " is ";
        appendNumber(detail, value->front());
        return fail(ErrorCode::kBadValue, where(by_key.find(key)->second),
                    detail + ", must be positive");
    }

    Result<double> numberOrZero(std::string_view key) const {
        if (!by_key.contains(key)) return 0.0;
        return numbers(key, 1).map([](const auto& list) { return list.front(); });
    }
};

Result<Values> readToml(const std::string& text, const std::string& path) {
    const auto short_enough = checkTomlLength(text, path);
    if (!short_enough) return tl::make_unexpected(short_enough.error());
    const auto table = parseToml(text, path);
    if (!table) return tl::make_unexpected(table.error());
    constexpr std::array kKnown = {"image", "resolution_m", "origin_x_m", "origin_y_m",
                                   "rotation_deg"};
    Values values{path, {}};
    for (const auto& [key, node] : *table) {
        const std::size_t line = key.source().begin.line;
        if (std::ranges::find(kKnown, key.str()) == kKnown.end()) {
            return fail(ErrorCode::kBadValue, path + ':' + std::to_string(line),
                        "unknown key " + std::string(key.str()));
        }
        Value& value = values.by_key[std::string(key.str())];
        value.line = line;
        if (node.is_string()) value.text = **node.as_string();
        if (const auto* number = node.as_floating_point()) value.numbers = {number->get()};
        if (const auto* number = node.as_integer()) {
            value.numbers = {static_cast<double>(number->get())};
        }
    }
    return values;
}

std::string_view withoutComment(std::string_view text) {
    const std::size_t hash = text.find(" #");
    return trimmed(text.starts_with('#') ? std::string_view{} : text.substr(0, hash));
}

// "3.5" or "[1, 2, 3.]"; empty where anything else stands there.
std::vector<double> parseNumbers(std::string_view text) {
    if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    while (true) {
        const std::size_t comma = text.find(',');
        const auto number = parseNumber(trimmed(text.substr(0, comma)));
        if (!number) return {};
        numbers.push_back(*number);
        if (comma == std::string_view::npos) return numbers;
        text.remove_prefix(comma + 1);
    }
}

std::string unquoted(std::string_view text) {
    const bool quoted = text.size() >= 2 && text.front() == text.back() &&
                        (text.front() == '"' || text.front() == '\'');
    return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

// The part of YAML that map_server writes: one `key: value` per line.
Result<Values> readYaml(const std::string& text, const std::string& path) {
    Values values{path, {}};
    std::string_view rest = text;
    for (std::size_t line = 1; !rest.empty(); ++line) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view content = withoutComment(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (content.empty() || content.starts_with("---") || content.starts_with('%')) continue;
        const std::size_t colon = content.find(':');
        if (colon == std::string_view::npos) {
            return fail(ErrorCode::kBadFormat, path + ':' + std::to_string(line),
                        "expected \"key: value\"");
        }
        const std::string_view value = trimmed(content.substr(colon + 1));
        values.by_key[std::string(trimmed(content.substr(0, colon)))] = {unquoted(value),
                                                                         parseNumbers(value), line};
    }
    return values;
}

Result<PlanPlacement> placementFromToml(const Values& values) {
    const auto resolution = values.resolution("resolution_m");
    if (!resolution) return tl::make_unexpected(resolution.error());
    PlanPlacement placement{.resolution_m = *resolution};
    const std::array<std::pair<const char*, double*>, 3> fields = {
        {{"origin_x_m", &placement.origin.position.x},
         {"origin_y_m", &placement.origin.position.y},
         {"rotation_deg", &placement.origin.heading_rad}}};
    for (const auto& [key, field] : fields) {
        const auto number = values.numberOrZero(key);
        if (!number) return tl::make_unexpected(number.error());
        *field = *number;
    }
    placement.origin.heading_rad = radFromDeg(placement.origin.heading_rad);
    return placement;
}

Result<PlanPlacement> placementFromYaml(const Values& values) {
    const auto resolution = values.resolution("resolution");
    if (!resolution) return tl::make_unexpected(resolution.error());
    const auto origin = values.numbers("origin", 3);
    if (!origin) return tl::make_unexpected(origin.error());
    return PlanPlacement{*resolution, {{origin->at(0), origin->at(1)}, origin->at(2)}};
}

}  // namespace

bool isPlacementFile(const std::filesystem::path& file) {
    const std::filesystem::path extension = file.extension();
    return extension == ".toml" || extension == ".yaml" || extension == ".yml";
}

Result<PlacementFile> loadPlacement(const std::filesystem::path& file) {
    return readTextFile(file).and_then(
        [&](const std::string& text) { return parsePlacement(text, file); });
}

Result<PlacementFile> parsePlacement(const std::string& text, const std::filesystem::path& file) {
    const bool is_toml = file.extension() == ".toml";
    const auto values = is_toml ? readToml(text, file.string()) : readYaml(text, file.string());
    if (!values) return tl::make_unexpected(values.error());
    const auto image = values->text("image");
    if (!image) return tl::make_unexpected(image.error());
    const auto placement = is_toml ? placementFromToml(*values) : placementFromYaml(*values);
    if (!placement) return tl::make_unexpected(placement.error());
    return PlacementFile{file.parent_path() / *image, *placement};
}

Result<void> savePlacement(const PlacementFile& placement, const std::filesystem::path& toml_file) {
    const PlanPlacement& p = placement.placement;
    std::filesystem::path image = placement.image_file;
    if (image.has_parent_path())
        image = portablePath(image, std::filesystem::absolute(toml_file).parent_path());
    std::string text = "image = " + quotedToml(image.generic_string()) + '\n';
    const std::array<std::pair<const char*, double>, 4> numbers = {
        {{"resolution_m", p.resolution_m},
         {"origin_x_m", p.origin.position.x},
         {"origin_y_m", p.origin.position.y},
         {"rotation_deg", degFromRad(p.origin.heading_rad)}}};
    for (const auto& [key, value] : numbers) {
        text += std::string(key) + " = ";
        const std::size_t begin = text.size();
        appendNumber(text, value);
        // A whole number with so many digits that TOML has no integer for it stays a number.
        if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";
        text += '\n';
    }
    return writeTextFile(toml_file, text);
}

}  // namespace hedr
