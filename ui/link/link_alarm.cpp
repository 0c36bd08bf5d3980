#include "ui/link/link_alarm.h"

#include <chrono>
#include <utility>

namespace hedr {

bool LinkAlarm::sounds(LinkState state, ReceiveClock::time_point now) {
    constexpr std::chrono::seconds kQuiet{10};
    if (state != LinkState::kLost) {
        if (lost_ && now - *lost_ >= kQuiet) told_ = false;
        return false;
    }
    lost_ = now;
    return !std::exchange(told_, true);
}

}  // namespace hedr
