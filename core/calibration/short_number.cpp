#include "core/calibration/short_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hedr {

std::string shortNumber(double value, int significant_digits) {
    if (!std::isfinite(value)) return "?";
    constexpr int kMostDecimals = 12;
    const int magnitude =
        value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
    const int decimals = std::clamp(significant_digits - 1 - magnitude, 0, kMostDecimals);
    char digits[400];  // the largest double has 309 before the point
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals)
            .ptr;
    std::string text(digits, end);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string percentText(double share) { return shortNumber(100.0 * share) + "\u00a0%"; }

}  // namespace hedr
