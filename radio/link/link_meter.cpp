#include "radio/link/link_meter.h"

#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr double kJitterShare = 1.0 / 16.0;  // RFC 3550, 6.4.1
constexpr double kClockJump_s = 5.0;         // no way takes so long: the robot was restarted

std::uint64_t grown(std::uint64_t before, std::uint64_t now) { return now - std::min(before, now); }

}  // namespace

void LinkMeter::noteFrames(double now_s, std::optional<double> robot_time_s) {
    if (last_frame_s_) longest_gap_s_ = std::max(longest_gap_s_, now_s - *last_frame_s_);
    last_frame_s_ = now_s;
    if (!robot_time_s) return;
    const double transit_s = now_s - *robot_time_s;
    const double step_s = last_transit_s_ ? std::abs(transit_s - *last_transit_s_) : 0.0;
    last_transit_s_ = transit_s;
    if (step_s < kClockJump_s) jitter_s_ += kJitterShare * (step_s - jitter_s_);
}

double LinkMeter::longestGap_s(double now_s) const {
    return last_frame_s_ ? std::max(longest_gap_s_, now_s - *last_frame_s_) : 0.0;
}

std::optional<LinkSample> LinkMeter::sampleIfDue(double now_s, const LinkHealth& health,
                                                 const Others& others) {
    if (!since_s_) {
        since_s_ = now_s;
        due_s_ = now_s + kPeriod_s;
        before_ = health;  // of a mission that goes on
    }
    if (now_s < due_s_) return std::nullopt;
    due_s_ = now_s < due_s_ + kPeriod_s ? due_s_ + kPeriod_s : now_s + kPeriod_s;
    const double passed_s = now_s - *since_s_;
    const auto good = static_cast<double>(grown(before_.good_frames, health.good_frames));
    const auto lost = static_cast<double>(grown(before_.lost_frames, health.lost_frames));
    const auto bad = static_cast<double>(grown(before_.bad_frames, health.bad_frames));
    const LinkSample sample{.receive_time_s = now_s,
                            .loss = good + lost > 0.0 ? lost / (good + lost) : 0.0,
                            .frames_per_s = good / passed_s,
                            .bad_frames_per_s = bad / passed_s,
                            .longest_gap_s = longestGap_s(now_s),
                            .jitter_s = jitter_s_,
                            .round_trip_s = others.round_trip_s,
                            .clock_offset_s = others.clock_offset_s,
                            .radio_dbm = others.radio_dbm};
    before_ = health;
    since_s_ = now_s;
    longest_gap_s_ = 0.0;
    return sample;
}

}  // namespace hedr
