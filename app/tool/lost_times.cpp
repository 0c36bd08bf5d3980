#include "app/tool/lost_times.h"

#include <iostream>

namespace hedr::tool {

void LostTimes::note(const Tracker& tracker) {
    // One that runs along with a better one says nothing.
    const auto bayes = tracker.bayesStatus();
    const HedrStatus* hedr = tracker.hedrStatus();
    const bool lost = bayes ? bayes->lost : hedr && hedr->lost;
    if (lost == lost_) return;
    if (lost_) tell(tracker.motion().t_s);
    lost_ = lost;
    since_s_ = tracker.motion().t_s;
}

void LostTimes::finish(double t_s) const {
    if (lost_) tell(t_s);
}

void LostTimes::tell(double until_s) const {
    std::cerr << "hedr: LOST LOCK from " << since_s_ << " s to " << until_s
              << " s: the direction of the corridors was not known\n";
}

}  // namespace hedr::tool
