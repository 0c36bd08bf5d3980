#pragma once

#include "core/fusion/tracker.h"

namespace hedr::tool {

// Says when the heading had nothing to hold on to.
class LostTimes {
  public:
    void note(const Tracker& tracker);
    void finish(double t_s) const;

  private:
    void tell(double until_s) const;

    bool lost_ = false;
    double since_s_ = 0.0;
};

}  // namespace hedr::tool
