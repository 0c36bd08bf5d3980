#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/robot/text_column.h"

namespace hedr {

// The parts of a line, without the spaces around them.
struct TextFields {
    std::array<std::string_view, kMaxTextColumns> fields{};
    std::size_t size = 0;
    std::span<const std::string_view> view() const { return std::span(fields).first(size); }
};

// Parts between semicolons, else tabs, else commas; one separator at the end is none. None where
// there are more than kMaxTextColumns.
std::optional<TextFields> splitFields(std::string_view line);

struct TextPairs {
    TextFields keys;
    TextFields values;
};

// "left:12,right:13" or "left=12 right=13": keys and values between any separators. None where the
// line is not made of such pairs.
std::optional<TextPairs> splitPairs(std::string_view line);

// Equal but for the case of letters A to Z; `upper` in capitals.
bool isWord(std::string_view text, std::string_view upper);

}  // namespace hedr
