#include "ui/link_state.h"

#include <algorithm>

namespace hedr {
namespace {

using TimePoint = ReceiveClock::time_point;

double ageOf(const std::optional<TimePoint>& moment, TimePoint now) {
    // The radio thread may have stamped it a moment after the GUI read its clock.
    return moment ? std::max(0.0, std::chrono::duration<double>(now - *moment).count()) : 0.0;
}

LinkState stateOf(const LinkFacts& facts, double age_s) {
    if (facts.port == PortState::kClosed) return LinkState::kOff;
    if (!facts.last_frame) return LinkState::kWaiting;
    if (age_s >= kLostAfter_s) return LinkState::kLost;
    return age_s >= kStaleAfter_s ? LinkState::kStale : LinkState::kLive;
}

LinkTrouble troubleOf(const LinkFacts& facts, double age_s, TimePoint now) {
    if (facts.port == PortState::kClosed) return LinkTrouble::kNone;
    if (facts.port == PortState::kGone) return LinkTrouble::kDeviceGone;
    const double patience_s = facts.last_frame ? kStaleAfter_s : kLostAfter_s;
    if (age_s >= patience_s) {
        const auto recent = [now](const std::optional<TimePoint>& moment) {
            return moment && ageOf(moment, now) < kStaleAfter_s;
        };
        if (recent(facts.last_good)) return LinkTrouble::kNoMotion;
        const bool bytes_arrive = recent(facts.last_byte);
        return bytes_arrive ? LinkTrouble::kNoValidFrames : LinkTrouble::kNoBytes;
    }
    return facts.robot_faults != 0 ? LinkTrouble::kRobotFault : LinkTrouble::kNone;
}

}  // namespace

LinkVerdict judgeLink(const LinkFacts& facts, TimePoint now) {
    const double age_s = ageOf(facts.last_frame ? facts.last_frame : facts.opened, now);
    return {stateOf(facts, age_s), troubleOf(facts, age_s, now), age_s};
}

void LinkWatch::note(const LiveBatch& batch, ReceiveClock::time_point now) {
    if (batch.port == PortState::kClosed) {
        frame_of_earlier_link_ = batch.last_frame;
        facts_.opened.reset();
    } else if (!facts_.opened) {
        facts_.opened = now;
    }
    facts_.port = batch.port;
    facts_.last_byte = batch.last_byte;
    facts_.last_good = batch.last_good;
    facts_.last_frame = batch.last_frame;
    // A frame of the link before this one does not make this one live.
    if (batch.last_frame == frame_of_earlier_link_) facts_.last_frame.reset();
    facts_.robot_faults = batch.status ? batch.status->faults : std::uint16_t{0};
}

}  // namespace hedr
