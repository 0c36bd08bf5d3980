#pragma once

#include <optional>

#include "core/mission/link_sample.h"
#include "radio/link/link_health.h"

namespace hedr {

// How the link is, second by second. Times are seconds of the receive clock.
class LinkMeter {
  public:
    static constexpr double kPeriod_s = 1.0;

    // Good frames have come, the last of which says this robot time.
    void noteFrames(double now_s, std::optional<double> robot_time_s);

    struct Others {
        std::optional<double> round_trip_s{};
        std::optional<double> clock_offset_s{};
        std::optional<int> radio_dbm{};
    };
    // Once a second, what there was since the last sample; `health` counts since the beginning.
    std::optional<LinkSample> sampleIfDue(double now_s, const LinkHealth& health,
                                          const Others& others);

  private:
    double longestGap_s(double now_s) const;

    LinkHealth before_{};
    std::optional<double> since_s_{};
    double due_s_ = 0.0;
    std::optional<double> last_frame_s_{};
    double longest_gap_s_ = 0.0;
    std::optional<double> last_transit_s_{};  // receive time less robot time
    double jitter_s_ = 0.0;
};

}  // namespace hedr
