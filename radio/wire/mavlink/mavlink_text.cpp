#include "radio/wire/mavlink/mavlink_text.h"

namespace hedr {

// Notices, information and debugging speak for themselves.
std::string_view MavlinkTexts::severityWord(std::uint8_t severity) {
    constexpr std::array<std::string_view, 5> kWords{
        "Emergency: ", "Alert: ", "Critical: ", "Error: ", "Warning: "};
    return severity < kWords.size() ? kWords[severity] : std::string_view{};
}

}  // namespace hedr
