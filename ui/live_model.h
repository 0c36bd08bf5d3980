#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/track/track.h"
#include "radio/live_batch.h"
#include "ui/link_state.h"

namespace hedr {

// How far the heading can be trusted, as one word.
enum class Trust { kOff, kGood, kCoasting, kLostLock };

inline constexpr double kLeastReachSpeed_m_s = 1.0;

struct LiveTrail {
    std::string name;
    Track track;
};

// Everything that is known of the running mission. Plain values, no widgets; ages are judged by the
// clock that the caller reads.
class LiveModel {
  public:
    using TimePoint = ReceiveClock::time_point;

    void apply(const LiveBatch& batch, TimePoint now);
    void clear();

    const LiveBatch& last() const { return last_; }  // without its tracks
    const std::vector<LiveTrail>& trails() const { return trails_; }
    const LiveTrail* primary() const;  // the most trusted one, nullptr where there is none
    std::optional<Pose<World>> pose() const;
    std::optional<Point<World>> home() const;
    double homeDistance_m() const;
    double homeBearing_rad() const;                // from the robot
    double apart_m(const LiveTrail& trail) const;  // from the primary, now
    // How far it may have gone since it was last heard: at the fastest speed so far, and no slower
    // than kLeastReachSpeed_m_s, for the link may have gone before the robot was driven fast.
    double reach_m(TimePoint now) const;

    LinkVerdict link(TimePoint now) const;
    Trust trust(TimePoint now) const;
    PoseVariance variance() const;  // of the primary one, now
    double missionDuration_s(TimePoint now) const;

  private:
    void append(const NamedPoints& points);
    void noteLink(const LiveBatch& batch, TimePoint now);

    LiveBatch last_;
    std::vector<LiveTrail> trails_;
    LinkFacts facts_;
    std::optional<TimePoint> frame_of_earlier_link_;
    std::optional<TimePoint> mission_start_;
    double top_speed_m_s_ = 0.0;
};

}  // namespace hedr
