// Whatever a robot prints, and however it is cut: no crash, finite times and short plain words;
// noise is cut into the same lines.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "radio/wire/text_line/text_line_reports.h"

namespace {

void demand(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void check(const hedr::Report& report) {
    if (const auto* sensors = std::get_if<hedr::SensorReport>(&report)) {
        demand(std::isfinite(sensors->robot_time_s));
    }
    if (const auto* event = std::get_if<hedr::EventReport>(&report)) {
        demand(std::isfinite(event->robot_time_s) && event->text.size() <= 120);
        demand(event->text.find_first_of("\n\r\t\x1B\x7F") == std::string::npos);
    }
}

// The first byte chooses what the vehicle file says.
std::optional<hedr::TextLineFormat> formatOf(std::uint8_t choice) {
    switch (choice % 4) {
        case 1:
            return hedr::TextLineFormat{.rate_hz = 50.0};
        case 2:
            return hedr::TextLineFormat{.columns = {"t_ms", "left", "right", "-", "gyro_dps"}};
        case 3:
            return hedr::TextLineFormat{.columns = {"left_m", "right_m"}, .rate_hz = 10.0};
        default:
            return std::nullopt;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto bytes = std::span(data, size).subspan(1);
    std::vector<hedr::Report> reports;
    std::vector<hedr::Report> again;
    hedr::TextLineReports whole(formatOf(data[0]));
    whole.feed(bytes, [&](const hedr::Report& report) {
        check(report);
        reports.push_back(report);
    });
    demand(whole.recognised() || reports.empty());
    hedr::TextLineReports cut(formatOf(data[0]));
    for (const std::uint8_t& byte : bytes) {
        cut.feed(std::span(&byte, 1), [&](const hedr::Report& r) { again.push_back(r); });
    }
    demand(whole.counters() == cut.counters());
    demand(reports == again);
    return 0;
}
