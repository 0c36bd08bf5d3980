#include "core/text/clean_text.h"

#include <cstdint>

namespace hedr {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

struct Character {
    std::size_t bytes = 1;
    std::uint32_t code = 0;
    bool valid = false;
};

// The first character of a text that is not empty.
Character firstOf(std::string_view text) {
    const auto lead = static_cast<std::uint8_t>(text.front());
    if (lead < 0x80) return {1, lead, true};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0x7FU >> bytes);
    for (const char each : text.substr(1, bytes - 1)) {
        const auto byte = static_cast<std::uint8_t>(each);
        if ((byte & 0xC0U) != 0x80) return {};
        code = code << 6U | (byte & 0x3FU);
    }
    constexpr std::uint32_t kSmallestCode[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kSmallestCode[bytes] || code > 0x10FFFF || surrogate) return {};
    return {bytes, code, true};
}

bool turnsDirection(std::uint32_t code) {
    return code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

bool isControl(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029;
}

}  // namespace

std::string cleanText(std::string_view text, std::size_t longest_bytes) {
    std::string clean;
    while (!text.empty()) {
        const Character next = firstOf(text);
        std::string_view shown = text.substr(0, next.bytes);
        if (!next.valid || turnsDirection(next.code)) shown = kReplacement;
        if (next.valid && isControl(next.code)) shown = " ";
        if (clean.size() + shown.size() > longest_bytes) break;
        clean += shown;
        text.remove_prefix(next.bytes);
    }
    return clean;
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Character next = firstOf(text);
        if (!next.valid) return false;
        text.remove_prefix(next.bytes);
    }
    return true;
}

}  // namespace hedr
