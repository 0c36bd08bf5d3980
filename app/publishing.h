#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/site/site.h"
#include "radio/publish/pose_publisher.h"
#include "ui/live_model.h"

namespace hedr {

// What other programs are told of one robot: the primary trail's pose, as the window shows it. None
// while there is no pose, no connection, or nothing was heard yet.
std::optional<PublishedPose> poseToPublish(const LiveModel& robot, const std::string& call_sign,
                                           const Site& site, ReceiveClock::time_point now);

// Publishes poses to the targets that the operator has named; to none at first. Lives in the GUI's
// thread and never blocks it.
class Publishing : public QObject {
    Q_OBJECT

  public:
    explicit Publishing(QObject* parent = nullptr);

    void setTargets(const std::vector<PublishTarget>& targets);
    // Of all robots, the one that is chosen first, as often as anything has changed. What has no
    // pose is left out; with none, nothing is told any more.
    void publish(std::vector<PublishedPose> poses) { publisher_.setPoses(std::move(poses)); }
    std::vector<PublishState> states() const { return publisher_.states(); }

  signals:
    void stateChanged();
    void failed(const hedr::Error& error);  // each trouble of a target once

  private:
    void tellTroubles();

    PosePublisher publisher_;
    std::vector<std::pair<PublishTarget, ErrorCode>> told_;
};

}  // namespace hedr
