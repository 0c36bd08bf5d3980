#include "radio/wire/text_line/text_fields.h"

#include <algorithm>

#include "core/text/trimmed.h"

namespace hedr {
namespace {

constexpr std::string_view kSpace = " \t";
constexpr std::string_view kSeparators = ",; \t";

char separatorOf(std::string_view line) {
    for (const char separator : {';', '\t'}) {
        if (line.find(separator) != std::string_view::npos) return separator;
    }
    return ',';
}

bool add(TextFields& fields, std::string_view field) {
    if (fields.size == fields.fields.size()) return false;
    fields.fields[fields.size++] = trimmed(field);
    return true;
}

void removeLeading(std::string_view& text, std::string_view unwanted) {
    text.remove_prefix(std::min(text.find_first_not_of(unwanted), text.size()));
}

}  // namespace

bool isWord(std::string_view text, std::string_view upper) {
    const auto capital = [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; };
    return std::equal(text.begin(), text.end(), upper.begin(), upper.end(),
                      [&](char c, char wanted) { return capital(c) == wanted; });
}

std::optional<TextFields> splitFields(std::string_view line) {
    line = trimmed(line);
    const char separator = separatorOf(line);
    if (line.ends_with(separator)) line.remove_suffix(1);
    TextFields fields;
    for (;;) {
        const std::size_t end = std::min(line.find(separator), line.size());
        if (!add(fields, line.substr(0, end))) return std::nullopt;
        if (end == line.size()) return fields;
        line.remove_prefix(end + 1);
    }
}

std::optional<TextPairs> splitPairs(std::string_view line) {
    TextPairs pairs;
    line = trimmed(line);
    while (!line.empty()) {
        const std::size_t colon = line.find_first_of(":=");
        if (colon == std::string_view::npos) return std::nullopt;
        const std::string_view key = trimmed(line.substr(0, colon));
        if (key.empty() || key.find_first_of(",;\t") != std::string_view::npos) return std::nullopt;
        line.remove_prefix(colon + 1);
        removeLeading(line, kSpace);
        const std::size_t end = std::min(line.find_first_of(kSeparators), line.size());
        if (end == 0 || !add(pairs.keys, key) || !add(pairs.values, line.substr(0, end))) {
            return std::nullopt;
        }
        line.remove_prefix(end);
        removeLeading(line, kSeparators);
    }
    return pairs.keys.size > 0 ? std::optional(pairs) : std::nullopt;
}

}  // namespace hedr
