#include <algorithm>

#include "radio/receiver.h"

namespace hedr {

// Its own words for the same things: what it removes besides the bias that was measured standing.
HedrStatus Receiver::bayesStatus(const BayesStatus& bayes) const {
    HedrStatus status{.state = HedrState::kSuspended,
                      .drift_rad_s = bayes.bias_rad_s - tracker_->motion().gyro_bias_rad_s,
                      .seconds_since_active = bayes_idle_s_,
                      .lost = bayes.lost};
    if (standing()) {
        status.reason = SuspendReason::kStanding;
    } else if (bayes.searching) {
        status.reason = SuspendReason::kSearching;
    } else if (bayes.leg == LegKind::kNone) {
        status.reason = SuspendReason::kTurning;
    } else if (bayes.alongCorridor()) {
        status.state = HedrState::kActive;
    }
    return status;
}

// The robot does not say whether it is lost.
HedrStatus Receiver::robotStatus() const {
    const double now_s = std::max(last_robot_point_->t_s, tracker_->motion().t_s);
    return {.state = robot_pose_->hedr,
            .reason = robot_pose_->reason,
            .drift_rad_s = robot_pose_->drift_rad_s,
            .seconds_since_active = now_s - robot_active_t_s_};
}

std::vector<NamedStatus> Receiver::statuses() const {
    std::vector<NamedStatus> statuses;
    if (!tracker_) return statuses;
    if (const auto bayes = tracker_->bayesStatus()) {
        statuses.push_back({"hedr_bayes", bayesStatus(*bayes)});
    }
    if (const HedrStatus* hedr = tracker_->hedrStatus()) statuses.push_back({"hedr", *hedr});
    if (last_robot_point_) statuses.push_back({kRobotTrack, robotStatus()});
    return statuses;
}

}  // namespace hedr
