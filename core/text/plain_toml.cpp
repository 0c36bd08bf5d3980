#include "core/text/plain_toml.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>

#include "core/text/text_file.h"

namespace hedr {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }

std::string escape(std::uint32_t code) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), code > 0xFFFF ? "\\U%08X" : "\\u%04X", code);
    return text.data();
}

// Takes the first letter of an UTF-8 text off it; nothing where it is none.
std::optional<std::uint32_t> takeLetter(std::string_view& text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if ((first >= 0x80 && first < 0xC2) || first > 0xF4 || text.size() < size) return std::nullopt;
    std::uint32_t code = size == 1 ? first : first & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
        const auto next = static_cast<unsigned char>(text[i]);
        if ((next & 0xC0U) != 0x80U) return std::nullopt;
        code = code << 6U | (next & 0x3FU);
    }
    text.remove_prefix(size);
    return code;
}

// Where the string that begins a line ends, behind its quote; npos where it does not.
std::size_t endOfString(std::string_view line) {
    const char quote = line.front();
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (quote == '"' && line[i] == '\\') {
            ++i;
        } else if (line[i] == quote) {
            return i + 1;
        }
    }
    return std::string_view::npos;
}

// Makes a line plain, piece by piece; `wrong` says what it stumbled over.
struct PlainLine {
    std::string text{};
    const char* wrong = nullptr;
    int dots_of_keys = 0;
    bool in_fraction = false;

    void addString(std::string_view string) {
        const std::string quoted = string.front() == '"'
                                       ? std::string(string)
                                       : quotedToml(string.substr(1, string.size() - 2));
        for (std::string_view rest = quoted; !rest.empty() && !wrong;) {
            const bool ascii = isAscii(rest.front());
            const auto letter = takeLetter(rest);
            if (!letter) wrong = "it is no UTF-8";
            if (letter)
                text += ascii ? std::string(1, static_cast<char>(*letter)) : escape(*letter);
        }
    }

    void add(char c) {
        if (!isAscii(c)) wrong = "only strings and comments may hold this letter";
        if (c == '.') {
            // 1.5 is a number; of 1.5.2 the second dot is a key's.
            const bool number = !text.empty() && isDigit(text.back()) && !in_fraction;
            if (!number && ++dots_of_keys > 1) wrong = "its keys are nested too deep";
            in_fraction = true;
        } else if (!isDigit(c)) {
            in_fraction = false;
        }
        text += c;
    }
};

PlainLine plainLine(std::string_view line) {
    PlainLine plain;
    while (!line.empty() && line.front() != '#' && !plain.wrong) {
        if (line.front() != '"' && line.front() != '\'') {
            plain.add(line.front());
            line.remove_prefix(1);
            continue;
        }
        const std::size_t end = endOfString(line);
        const bool several_lines = line.starts_with("\"\"\"") || line.starts_with("'''");
        if (several_lines || end == std::string_view::npos) {
            plain.wrong = "a string must end on its line";
            break;
        }
        plain.addString(line.substr(0, end));
        line.remove_prefix(end);
    }
    return plain;
}

}  // namespace

Result<std::string> plainToml(std::string_view toml, const std::string& path) {
    toml = withoutByteOrderMark(toml);
    std::string plain;
    for (std::size_t number = 1; !toml.empty(); ++number) {
        const std::size_t end = std::min(toml.find('\n'), toml.size());
        const PlainLine line = plainLine(toml.substr(0, end));
        if (line.wrong)
            return fail(ErrorCode::kBadFormat, path + ':' + std::to_string(number), line.wrong);
        plain += line.text + '\n';
        toml.remove_prefix(std::min(end + 1, toml.size()));
    }
    return plain;
}

std::string quotedToml(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') quoted += '\\';
        if (code < 0x20 || code == 0x7F) {
            quoted += escape(code);
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

}  // namespace hedr
