#pragma once

#include "core/robot/report.h"
#include "core/track/track.h"

namespace hedr {

// What HEDR is doing now, for the operator.
struct HedrStatus {
    HedrState state = HedrState::kOff;
    SuspendReason reason = SuspendReason::kNone;
    double drift_rad_s = 0.0;           // running mean of what is removed
    double seconds_since_active = 0.0;  // time since the last compliant driving
    bool held_expired = false;          // the learnt drift is too old and is not applied
    bool lost = false;                  // what is driven straight runs along no dominant direction
    friend bool operator==(const HedrStatus&, const HedrStatus&) = default;
};

}  // namespace hedr
