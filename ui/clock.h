#pragma once

#include <QDateTime>
#include <functional>

#include "radio/live_batch.h"

namespace hedr {

// The GUI's clocks. Ages are judged by the monotonic one, which is also the receive clock; the wall
// clock only names the moment of the last packet. Tests put their own in.
struct Clock {
    std::function<ReceiveClock::time_point()> now = [] { return ReceiveClock::now(); };
    std::function<QDateTime()> wall_now = [] { return QDateTime::currentDateTime(); };
};

}  // namespace hedr
