#pragma once

#include <array>
#include <chrono>
#include <optional>

namespace hedr {

inline constexpr std::array kUsualBauds{57600, 115200, 9600, 38400, 230400, 19200, 460800, 921600};

// Which rate to try next on a port whose robot is not understood. A rate is given up when bytes
// have come at it for a while and none of them made sense; silence says nothing about a rate. The
// first round through all rates takes less than 5 s, later ones are patient with slow talkers.
class BaudSearch {
  public:
    using Clock = std::chrono::steady_clock;

    explicit BaudSearch(int first = kUsualBauds.front()) : baud_(first) {}

    int baud() const { return baud_; }
    bool settled() const { return settled_; }
    // What came at this rate made sense.
    void settle() { settled_ = true; }
    // Bytes have come. The rate to go on with, where that is another one.
    std::optional<int> noteBytes(Clock::time_point now);

  private:
    static constexpr std::chrono::milliseconds kFirstRound{500};
    static constexpr std::chrono::milliseconds kLaterRounds{2500};

    int nextBaud();

    int baud_;
    bool settled_ = false;
    std::size_t tried_ = 0;
    std::optional<Clock::time_point> first_byte_{};  // at this rate
};

}  // namespace hedr
