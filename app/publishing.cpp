#include "app/publishing.h"

#include <algorithm>

namespace hedr {

namespace {

PublishedTrust published(Trust trust) {
    switch (trust) {
        case Trust::kGood:
            return PublishedTrust::kGood;
        case Trust::kCoasting:
            return PublishedTrust::kCoasting;
        case Trust::kLostLock:
            return PublishedTrust::kLostLock;
        case Trust::kOff:
            break;
    }
    return PublishedTrust::kOff;
}

}  // namespace

std::optional<PublishedPose> poseToPublish(const LiveModel& robot, const std::string& call_sign,
                                           const Site& site, ReceiveClock::time_point now) {
    const auto pose = robot.pose();
    const LiveBatch& last = robot.last();
    if (!pose || !last.last_frame || last.port == PortState::kClosed) return std::nullopt;
    const bool named = robot.floor() < site.floors.size();
    return PublishedPose{.call_sign = call_sign,
                         .heard = *last.last_frame,
                         .pose = *pose,
                         .variance = robot.variance(),
                         .speed_m_s = last.speed_m_s,
                         .trust = published(robot.trust(now)),
                         .estimator = robot.primary()->name,
                         .floor = named ? site.floors[robot.floor()].name : std::string(),
                         .tie = site.geo_tie};
}

Publishing::Publishing(QObject* parent) : QObject(parent) {
    connect(&publisher_, &PosePublisher::stateChanged, this, &Publishing::tellTroubles);
}

void Publishing::setTargets(const std::vector<PublishTarget>& targets) {
    told_.clear();
    publisher_.setTargets(targets);
}

void Publishing::tellTroubles() {
    for (const PublishState& state : publisher_.states()) {
        if (!state.error) continue;
        const std::pair trouble(state.target, state.error->code);
        if (std::ranges::find(told_, trouble) != told_.end()) continue;
        told_.push_back(trouble);
        emit failed(*state.error);
    }
    emit stateChanged();
}

}  // namespace hedr
