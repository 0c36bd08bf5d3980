#pragma once

#include <vector>

namespace hedr {

// A time through which the heading had nothing to hold on to.
struct LostTime {
    double from_s = 0.0;
    double until_s = 0.0;
};

// Gathers them point by point.
class LostTimes {
  public:
    void note(bool lost, double t_s) {
        if (lost && !lost_) times_.push_back({t_s, t_s});
        // It lasts to the first point that is not lost any more.
        if (lost || lost_) times_.back().until_s = t_s;
        lost_ = lost;
    }
    const std::vector<LostTime>& times() const { return times_; }

  private:
    std::vector<LostTime> times_;
    bool lost_ = false;
};

}  // namespace hedr
