#pragma once

#include <cstdint>
#include <optional>

namespace hedr {

// Watches whether a robot says often enough how it moves. One that does not is asked for more, a
// few times; where that does not help, its operator has to know. Times are seconds of the receive
// clock.
class SensorRate {
  public:
    static constexpr double kEnough_hz = 10.0;
    static constexpr double kWindow_s = 3.0;
    static constexpr int kTimesToAsk = 3;

    enum class Advice { kNone, kAsk, kWarn };

    // Now and then, `reports` counted since the beginning. Each advice is given once: kAsk after a
    // window with too few, kWarn, once, after one when all asking was in vain. A window between
    // good ones, as an outage makes it, is no reason to warn.
    Advice look(double now_s, std::uint64_t reports);
    // The robot was restarted, or its port opened: it may have forgotten what it was asked.
    void startAgain() { *this = {}; }
    // Over the last whole window.
    double rate_hz() const { return rate_hz_; }

  private:
    std::optional<double> since_s_{};
    std::uint64_t reports_before_ = 0;
    double rate_hz_ = 0.0;
    int asked_ = 0;  // since the last window with enough; more than kTimesToAsk: warned
};

}  // namespace hedr
