#include "radio/wire/text_line/plain_text.h"

#include <cstdint>

namespace hedr {
namespace {

struct Letter {
    std::uint32_t code = 0;
    std::size_t size = 1;
};

std::optional<Letter> firstLetter(std::string_view text) {
    const auto at = [text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = at(0);
    if (lead < 0x80) return Letter{lead, 1};
    const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return std::nullopt;
    std::uint32_t code = lead & (0x7Fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((at(i) & 0xC0u) != 0x80u) return std::nullopt;
        code = code << 6 | (at(i) & 0x3Fu);
    }
    const bool overlong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (overlong || surrogate || code > 0x10FFFF) return std::nullopt;
    return Letter{code, size};
}

// Controls, and letters without a shape that order or hide their neighbours.
bool hidden(std::uint32_t code) {
    const auto within = [code](std::uint32_t low, std::uint32_t high) {
        return code >= low && code <= high;
    };
    return code < 0x20 || within(0x7F, 0x9F) || code == 0xAD || code == 0x61C ||
           within(0x200B, 0x200F) || within(0x2028, 0x202E) || within(0x2060, 0x206F) ||
           code == 0xFEFF || within(0xFFF0, 0xFFFB) || within(0xE0000, 0xE0FFF);
}

}  // namespace

std::optional<std::string> plainText(std::string_view text, std::size_t longest) {
    std::string plain;
    bool full = false;
    while (!text.empty()) {
        const auto letter = firstLetter(text);
        if (!letter) return std::nullopt;
        full = full || plain.size() + letter->size > longest;
        if (letter->code == '\t' && !full) {
            plain += ' ';
        } else if (!hidden(letter->code) && !full) {
            plain.append(text.substr(0, letter->size));
        }
        text.remove_prefix(letter->size);
    }
    return plain;
}

}  // namespace hedr
