#include "core/calibration/short_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hedr {

std::string shortNumber(double value, int significant_digits) {
    if (!std::isfinite(value)) return "?";
    constexpr int kMostDecimals = 12;
    constexpr int kMostDigits = 12;  // before the point: what has more is an error somewhere
    const int magnitude =
        value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
    const bool is_vast = magnitude >= kMostDigits;
    const auto format = is_vast ? std::chars_format::scientific : std::chars_format::fixed;
    const int decimals =
        is_vast ? 0 : std::clamp(significant_digits - 1 - magnitude, 0, kMostDecimals);
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, format, decimals).ptr;
    std::string text(digits, end);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string percentText(double share) { return shortNumber(100.0 * share) + "\u00a0%"; }

}  // namespace hedr
