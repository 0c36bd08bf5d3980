#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/track/track.h"
#include "radio/live_batch.h"
#include "ui/link_state.h"
#include "ui/trail_choice.h"

namespace hedr {

// How far the heading can be trusted, as one word.
enum class Trust { kOff, kGood, kCoasting, kLostLock };

inline constexpr double kLeastReachSpeed_m_s = 1.0;

struct LiveTrail {
    std::string name;
    Track track;
};

// A stretch of the drive that lies behind: its trails stay on the floor where they were driven.
struct LeftTrails {
    std::size_t floor = 0;
    std::vector<LiveTrail> trails;
};

// Everything that is known of the running mission. Plain values, no widgets; ages are judged by the
// clock that the caller reads.
class LiveModel {
  public:
    using TimePoint = ReceiveClock::time_point;

    void apply(const LiveBatch& batch, TimePoint now);
    void clear();
    // The robot is on that floor from now on. Said by mistake and taken back, without driving
    // there, it leaves nothing behind.
    void setFloorNames(std::vector<std::string> names) { floor_names_ = std::move(names); }
    void setFloor(std::size_t floor);
    std::size_t floor() const { return floor_; }

    const LiveBatch& last() const { return last_; }                   // without its tracks
    const std::vector<LiveTrail>& trails() const { return trails_; }  // as trailStyles() has them

    const std::vector<LinkSample>& linkHistory() const { return link_history_; }  // a second each
    const std::vector<LeftTrails>& left() const { return left_; }  // in the order driven

    void setChoice(const TrailChoice& choice) { choice_ = choice; }
    const TrailChoice& choice() const { return choice_; }
    void choosePrimary(const std::string& name);  // shows it too
    void showTrail(const std::string& name, bool shown) { choice_.shown[name] = shown; }
    bool isShown(const LiveTrail& trail) const { return hedr::isShown(choice_, trail.name); }
    // The chosen one, the most trusted one where that is not there, nullptr where there is none.
    // Pose, home, apart, trust and variance are the primary trail's.
    const LiveTrail* primary() const;
    const LiveTrail* nextPrimary() const;  // the shown one after it, nullptr where there is none
    std::optional<Pose<World>> pose() const;
    std::optional<Point<World>> home() const;
    std::size_t homeFloor() const;
    std::size_t highestFloor() const;  // that the robot has been on
    double homeDistance_m() const;
    double homeBearing_rad() const;                // from the robot
    double apart_m(const LiveTrail& trail) const;  // now
    // How far it may have gone since it was last heard: at the fastest speed so far, and no slower
    // than kLeastReachSpeed_m_s, for the link may have gone before the robot was driven fast.
    double reach_m(TimePoint now) const;

    LinkVerdict link(TimePoint now) const;
    Trust trust(TimePoint now) const;
    HedrStatus status() const;  // of the primary; off where nothing checks the heading
    HedrStatus statusOf(const LiveTrail& trail) const;
    PoseVariance variance() const;  // now
    double missionDuration_s(TimePoint now) const;

  private:
    void appendTracks(const LiveBatch& batch);
    void append(const NamedPoints& points);
    bool saidByMistake(std::size_t floor) const;
    const LeftTrails* begun() const;  // where the primary trail began; nullptr: on this floor
    void noteLink(const LiveBatch& batch, TimePoint now);

    LiveBatch last_;
    std::vector<LiveTrail> trails_;
    std::vector<LeftTrails> left_;
    std::size_t floor_ = 0;
    std::vector<std::string> floor_names_;
    TrailChoice choice_;
    LinkWatch link_watch_;
    std::vector<LinkSample> link_history_;
    std::optional<TimePoint> mission_start_;
    double top_speed_m_s_ = 0.0;
};

}  // namespace hedr
