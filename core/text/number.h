#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hedr {

// The shortest text that reads back as the same bits, whatever the locale.
void appendNumber(std::string& text, double value);
void appendNumber(std::string& text, std::int64_t value);

// The whole of `text` as a number ("nan" and "inf" are numbers here), else nothing.
std::optional<double> parseNumber(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

}  // namespace hedr
