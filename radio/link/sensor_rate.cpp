#include "radio/link/sensor_rate.h"

#include <utility>

namespace hedr {

SensorRate::Advice SensorRate::look(double now_s, std::uint64_t reports) {
    if (!since_s_) {
        since_s_ = now_s;
        reports_before_ = reports;
    }
    const double passed_s = now_s - *since_s_;
    if (passed_s < kWindow_s) return Advice::kNone;
    rate_hz_ = static_cast<double>(reports - std::exchange(reports_before_, reports)) / passed_s;
    since_s_ = now_s;
    if (asked_ > kTimesToAsk) return Advice::kNone;
    if (rate_hz_ >= kEnough_hz) {
        asked_ = 0;
        return Advice::kNone;
    }
    return ++asked_ > kTimesToAsk ? Advice::kWarn : Advice::kAsk;
}

}  // namespace hedr
