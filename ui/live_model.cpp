#include "ui/live_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/trail_style.h"

namespace hedr {
namespace {

constexpr double kGoodWithin_s = 10.0;
constexpr double kNotDriven_m = 1.0;

const LiveTrail* find(const std::vector<LiveTrail>& trails, const std::string& name) {
    for (const LiveTrail& trail : trails) {
        if (trail.name == name) return &trail;
    }
    return nullptr;
}

}  // namespace

void LiveModel::apply(const LiveBatch& batch, TimePoint now) {
    appendTracks(batch);
    noteLink(batch, now);
    top_speed_m_s_ = std::max(top_speed_m_s_, std::abs(batch.speed_m_s));
    link_history_.insert(link_history_.end(), batch.link_samples.begin(), batch.link_samples.end());
    last_ = batch;
    last_.tracks.clear();
    last_.link_samples.clear();
    last_.restored_floors.clear();
    last_.restored_site.reset();
}

// Those of a continued mission go to the floors where they were driven.
void LiveModel::appendTracks(const LiveBatch& batch) {
    auto change = batch.restored_floors.begin();
    if (change != batch.restored_floors.end() && trails_.empty()) setFloor(0);
    const auto go_on = [&] {
        const auto floor = std::ranges::find(floor_names_, (change++)->floor);
        if (floor != floor_names_.end()) {
            setFloor(static_cast<std::size_t>(floor - floor_names_.begin()));
        }
    };
    for (const NamedPoints& points : batch.tracks) {
        while (change != batch.restored_floors.end() && !points.points.empty() &&
               points.points.front().t_s > change->t_s) {
            go_on();
        }
        append(points);
    }
    while (change != batch.restored_floors.end()) go_on();
}

void LiveModel::append(const NamedPoints& points) {
    if (points.points.empty()) return;
    auto trail = std::find_if(trails_.begin(), trails_.end(),
                              [&](const LiveTrail& t) { return t.name == points.name; });
    if (trail == trails_.end()) {
        trail = trails_.insert(std::find_if(trails_.begin(), trails_.end(),
                                            [&](const LiveTrail& t) {
                                                return trailRank(t.name) > trailRank(points.name);
                                            }),
                               LiveTrail{points.name, Track{}});
    }
    for (const TrackPoint& point : points.points) trail->track.append(point);
}

// The robot goes on where it is: its trails on the new floor begin there.
void LiveModel::setFloor(std::size_t floor) {
    if (floor == floor_) return;
    const bool back = saidByMistake(floor);
    std::vector<LiveTrail> here = std::exchange(trails_, {});
    if (back) {
        trails_ = std::move(left_.back().trails);
        left_.pop_back();
    }
    for (const LiveTrail& trail : here) {
        const std::size_t from = back ? 1 : trail.track.size() - 1;
        for (std::size_t i = from; i < trail.track.size(); ++i) {
            append({trail.name, {trail.track.at(i)}});
        }
    }
    if (!back && !here.empty()) left_.push_back({floor_, std::move(here)});
    floor_ = floor;
}

bool LiveModel::saidByMistake(std::size_t floor) const {
    if (left_.empty() || left_.back().floor != floor || trails_.empty()) return false;
    const WorldBox driven = primary()->track.bounds();
    return (driven.max - driven.min).length() < kNotDriven_m;
}

void LiveModel::noteLink(const LiveBatch& batch, TimePoint now) {
    link_watch_.note(batch, now);
    const LinkFacts& facts = link_watch_.facts();
    if (batch.mission_begin) mission_start_ = batch.mission_begin;
    if (!mission_start_ && facts.last_frame) mission_start_ = facts.last_frame;
}

void LiveModel::clear() {
    trails_.clear();
    left_.clear();
    mission_start_.reset();
    top_speed_m_s_ = 0.0;
}

void LiveModel::choosePrimary(const std::string& name) {
    choice_.primary = name;
    showTrail(name, true);
}

const LiveTrail* LiveModel::primary() const {
    if (const LiveTrail* chosen = find(trails_, choice_.primary)) return chosen;
    return trails_.empty() ? nullptr : &trails_.front();
}

const LiveTrail* LiveModel::nextPrimary() const {
    if (trails_.empty()) return nullptr;
    const auto at = static_cast<std::size_t>(primary() - trails_.data());
    for (std::size_t step = 1; step < trails_.size(); ++step) {
        const LiveTrail& trail = trails_[(at + step) % trails_.size()];
        if (isShown(trail)) return &trail;
    }
    return nullptr;
}

HedrStatus LiveModel::status() const {
    return trails_.empty() ? HedrStatus{} : statusOf(*primary());
}

HedrStatus LiveModel::statusOf(const LiveTrail& trail) const {
    for (const NamedStatus& named : last_.statuses) {
        if (named.name == trail.name) return named.status;
    }
    return {};
}

std::optional<Pose<World>> LiveModel::pose() const {
    if (trails_.empty()) return std::nullopt;
    return primary()->track.back().pose;
}

PoseVariance LiveModel::variance() const {
    return trails_.empty() ? PoseVariance{} : primary()->track.back().variance;
}

std::optional<Point<World>> LiveModel::home() const {
    if (trails_.empty()) return std::nullopt;
    const LeftTrails* left = begun();
    const LiveTrail* first = left ? find(left->trails, primary()->name) : primary();
    return first->track.at(0).pose.position;
}

std::size_t LiveModel::homeFloor() const {
    const LeftTrails* left = begun();
    return left ? left->floor : floor_;
}

std::size_t LiveModel::highestFloor() const {
    std::size_t highest = floor_;
    for (const LeftTrails& left : left_) highest = std::max(highest, left.floor);
    return highest;
}

const LeftTrails* LiveModel::begun() const {
    if (trails_.empty()) return nullptr;
    const auto left = std::ranges::find_if(
        left_, [this](const LeftTrails& l) { return find(l.trails, primary()->name) != nullptr; });
    return left == left_.end() ? nullptr : &*left;
}

double LiveModel::homeDistance_m() const {
    return trails_.empty() ? 0.0 : (*home() - pose()->position).length();
}

double LiveModel::homeBearing_rad() const {
    if (trails_.empty()) return 0.0;
    const Vector<World> way = *home() - pose()->position;
    return std::atan2(way.y, way.x);
}

double LiveModel::apart_m(const LiveTrail& trail) const {
    return (trail.track.back().pose.position - pose()->position).length();
}

double LiveModel::reach_m(TimePoint now) const {
    return std::max(kLeastReachSpeed_m_s, top_speed_m_s_) * link(now).age_s;
}

LinkVerdict LiveModel::link(TimePoint now) const { return judgeLink(link_watch_.facts(), now); }

Trust LiveModel::trust(TimePoint now) const {
    const LinkState state = link(now).state;
    const bool heard = state != LinkState::kOff && state != LinkState::kWaiting;
    const HedrStatus checked = status();
    if (!heard || checked.state == HedrState::kOff) return Trust::kOff;
    if (checked.lost) return Trust::kLostLock;
    const bool recent =
        checked.state == HedrState::kActive || checked.seconds_since_active < kGoodWithin_s;
    return recent && !isOld(state) && !checked.held_expired ? Trust::kGood : Trust::kCoasting;
}

double LiveModel::missionDuration_s(TimePoint now) const {
    if (!mission_start_) return 0.0;
    const TimePoint end = link_watch_.facts().port == PortState::kClosed
                              ? last_.last_frame.value_or(*mission_start_)
                              : now;
    return std::max(0.0, std::chrono::duration<double>(end - *mission_start_).count());
}

}  // namespace hedr
