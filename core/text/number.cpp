#include "core/text/number.h"

#include <charconv>

namespace hedr {
namespace {

template <class Number>
void append(std::string& text, Number value) {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text.append(digits, end);
}

template <class Number>
std::optional<Number> parse(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

void appendNumber(std::string& text, double value) { append(text, value); }
void appendNumber(std::string& text, std::int64_t value) { append(text, value); }

std::optional<double> parseNumber(std::string_view text) { return parse<double>(text); }
std::optional<std::int64_t> parseInteger(std::string_view text) {
    return parse<std::int64_t>(text);
}

}  // namespace hedr
