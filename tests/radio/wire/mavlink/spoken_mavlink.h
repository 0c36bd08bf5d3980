#pragma once

#include <utility>
#include <vector>

#include "radio/wire/mavlink/mavlink_codec.h"
#include "radio/wire/mavlink/mavlink_reports.h"

namespace hedr::test {

// A vehicle that says what it is told, and the reports that come of it.
class SpokenMavlink {
  public:
    explicit SpokenMavlink(MavlinkAddress address = {7, 1}) : address_(address) {}

    template <class Message>
    void say(const Message& message) {
        sayAs(address_, message);
    }
    template <class Message>
    void sayAs(MavlinkAddress address, const Message& message) {
        const MavlinkBytes bytes = encodeMavlink(
            message,
            {.sequence = sequence_++, .system = address.system, .component = address.component});
        reports_.feed(bytes.view(), [this](const Report& r) { heard_.push_back(r); });
    }
    // The reports since the last call, of one kind or all.
    std::vector<Report> take() { return std::exchange(heard_, {}); }
    template <class Kind>
    std::vector<Kind> take() {
        std::vector<Kind> result;
        for (const Report& report : take()) {
            if (const auto* kind = std::get_if<Kind>(&report)) result.push_back(*kind);
        }
        return result;
    }
    const MavlinkReports& reports() const { return reports_; }

  private:
    MavlinkAddress address_;
    std::uint8_t sequence_ = 0;
    MavlinkReports reports_;
    std::vector<Report> heard_;
};

inline MavlinkHeartbeat heartbeat(std::uint8_t autopilot = 0) {
    return {.type = 10, .autopilot = autopilot};  // a ground rover
}

}  // namespace hedr::test
