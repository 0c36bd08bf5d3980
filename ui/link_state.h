#pragma once

#include <optional>

#include "radio/link/link_age.h"
#include "radio/live_batch.h"

namespace hedr {

enum class LinkState { kOff, kWaiting, kLive, kStale, kLost };

// Why nothing good arrives, as far as this end of the radio can tell.
enum class LinkTrouble { kNone, kDeviceGone, kNoBytes, kNoValidFrames, kNoMotion, kRobotFault };

struct LinkFacts {
    PortState port = PortState::kClosed;
    std::optional<ReceiveClock::time_point> opened{};
    std::optional<ReceiveClock::time_point> last_byte{};   // since then
    std::optional<ReceiveClock::time_point> last_good{};   // frame since then
    std::optional<ReceiveClock::time_point> last_frame{};  // of those that say how it moves
    std::uint16_t robot_faults = 0;
};

struct LinkVerdict {
    LinkState state = LinkState::kOff;
    LinkTrouble trouble = LinkTrouble::kNone;
    double age_s = 0.0;  // of last_frame; of the wait where there was none yet
    friend bool operator==(const LinkVerdict&, const LinkVerdict&) = default;
};

// Nobody has connected to where this computer waits for the robot.
inline bool isAwaited(const LiveBatch& last) {
    return std::holds_alternative<TcpListenAddress>(last.address) && last.port_error &&
           last.port_error->code == ErrorCode::kPeerMissing;
}

// What was heard last is not true of this moment.
inline bool isOld(LinkState state) { return state != LinkState::kLive; }

// Follows the facts of one robot's link, over connections that end and begin again.
class LinkWatch {
  public:
    void note(const LiveBatch& batch, ReceiveClock::time_point now);
    const LinkFacts& facts() const { return facts_; }

  private:
    LinkFacts facts_{};
    std::optional<ReceiveClock::time_point> frame_of_earlier_link_{};
};

LinkVerdict judgeLink(const LinkFacts& facts, ReceiveClock::time_point now);

}  // namespace hedr
