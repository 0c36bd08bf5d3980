#pragma once

#include <algorithm>
#include <chrono>

namespace hedr {

// How far something that is played has come, in its own time.
class PlayPace {
  public:
    PlayPace(double first_s, double speed) : first_s_(first_s), speed_(speed) {}

    double now_s() const {
        const std::chrono::duration<double> played = Clock::now() - begin_;
        return first_s_ + speed_ * played.count();
    }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin_ = Clock::now();
    double first_s_;
    double speed_;
};

inline constexpr int kPlayTick_ms = 10;
// In one tick, so that the thread comes to other things however fast it is played.
inline constexpr int kMostBytesPerTick = 1 << 16;

}  // namespace hedr
