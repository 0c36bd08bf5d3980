#include "core/text/toml_depth.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace hedr {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// The rest of a line behind the string that begins it; nothing where the string does not end.
std::string_view behindString(std::string_view line) {
    const char quote = line.front();
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (quote == '"' && line[i] == '\\') {
            ++i;
        } else if (line[i] == quote) {
            return line.substr(i + 1);
        }
    }
    return {};
}

// What is wrong with a line; empty where nothing is.
const char* objection(std::string_view line) {
    int dots_of_keys = 0;
    bool in_fraction = false;
    char before = '\n';
    while (!line.empty() && line.front() != '#') {
        const char c = line.front();
        if (line.starts_with("\"\"\"") || line.starts_with("'''"))
            return "a string must stand on one line";
        if (c == '"' || c == '\'') {
            line = behindString(line);
            before = c;
            continue;
        }
        if (c == '.') {
            // 1.5 is a number; of 1.5.2 the second dot is a key's.
            const bool number = isDigit(before) && !in_fraction;
            if (!number && ++dots_of_keys > 1) return "its keys are nested too deep";
            in_fraction = true;
        } else if (!isDigit(c)) {
            in_fraction = false;
        }
        before = c;
        line.remove_prefix(1);
    }
    return nullptr;
}

}  // namespace

Result<void> checkTomlDepth(std::string_view toml, const std::string& path) {
    for (std::size_t line = 1; !toml.empty(); ++line) {
        const std::size_t end = std::min(toml.find('\n'), toml.size());
        if (const char* wrong = objection(toml.substr(0, end))) {
            return fail(ErrorCode::kBadFormat, path + ':' + std::to_string(line), wrong);
        }
        toml.remove_prefix(std::min(end + 1, toml.size()));
    }
    return {};
}

std::string quotedToml(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (code < 0x20 || code == 0x7F) {
            std::array<char, 8> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04X", code);
            quoted += escape.data();
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

}  // namespace hedr
