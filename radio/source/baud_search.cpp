#include "radio/source/baud_search.h"

#include <algorithm>

namespace hedr {

std::optional<int> BaudSearch::noteBytes(Clock::time_point now) {
    if (settled_) return std::nullopt;
    if (!first_byte_) first_byte_ = now;
    const auto patience = tried_ < kUsualBauds.size() ? kFirstRound : kLaterRounds;
    if (now - *first_byte_ < patience) return std::nullopt;
    first_byte_.reset();
    ++tried_;
    baud_ = nextBaud();
    return baud_;
}

int BaudSearch::nextBaud() {
    const auto* here = std::ranges::find(kUsualBauds, baud_);
    return here == kUsualBauds.end() || here + 1 == kUsualBauds.end() ? kUsualBauds.front()
                                                                      : *(here + 1);
}

}  // namespace hedr
