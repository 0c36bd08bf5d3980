#pragma once

#include <optional>

#include "radio/live_batch.h"
#include "ui/link_state.h"

namespace hedr {

// One tone for a link that is lost. A link that comes and goes is told once: the next tone needs
// ten seconds without a loss.
class LinkAlarm {
  public:
    bool sounds(LinkState state, ReceiveClock::time_point now);  // to be asked at every refresh

  private:
    bool told_ = false;
    std::optional<ReceiveClock::time_point> lost_{};  // last seen
};

}  // namespace hedr
