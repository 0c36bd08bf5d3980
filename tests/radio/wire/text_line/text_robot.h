#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radio/wire/text_line/text_line_reports.h"

namespace hedr::test {

inline std::span<const std::uint8_t> bytesOf(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// What is heard of a robot that prints lines.
struct HeardText {
    std::vector<Report> reports;
    WireCounters counters{};
    bool recognised = false;
    std::string refusal;

    template <class Kind>
    std::vector<Kind> all() const {
        std::vector<Kind> found;
        for (const Report& report : reports) {
            if (const auto* kind = std::get_if<Kind>(&report)) found.push_back(*kind);
        }
        return found;
    }
    friend bool operator==(const HeardText&, const HeardText&) = default;
};

inline HeardText hear(std::string_view text, const std::optional<TextLineFormat>& format = {},
                      std::size_t piece = std::string_view::npos) {
    HeardText heard;
    TextLineReports decoder(format);
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view some = text.substr(at, piece);
        decoder.feed(bytesOf(some), [&](const Report& r) { heard.reports.push_back(r); });
        at += some.size();
    }
    heard.counters = decoder.counters();
    heard.recognised = decoder.recognised();
    heard.refusal = decoder.refusal();
    return heard;
}

// Three lines; "%" in `line` becomes 0, 1, 2.
inline std::string spread(const std::string& line) {
    std::string text;
    for (const char digit : {'0', '1', '2'}) {
        for (const char c : line) text += c == '%' ? digit : c;
        text += "\r\n";
    }
    return text;
}

// A header, and lines that agree with it.
inline const std::string kRecognisedRobot =
    "t_ms,left_ticks,right_ticks,gyro_dps\n0,0,0,0\n20,1,1,0\n40,2,2,0\n";

}  // namespace hedr::test
