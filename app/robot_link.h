#pragma once

#include <QObject>
#include <QThread>
#include <chrono>
#include <string>

#include "radio/live_link.h"

namespace hedr {

// One robot's link, in a thread of its own: a port or a disk that hangs holds up no other robot.
// What is asked goes there, what is heard comes back by value.
class RobotLink : public QObject {
    Q_OBJECT

  public:
    explicit RobotLink(const LiveLink::Setup& setup, QObject* parent = nullptr);
    ~RobotLink() override;  // the mission is closed in good order

    void open(const LinkAddress& address);
    void close();
    void setFramePeriod(std::chrono::milliseconds period);
    void notePlan(const MissionPlan& plan);
    void noteSite(const Site& site);
    void noteFloor(const std::string& name);
    void ask(std::uint64_t ticket, const Request& request);
    void cancelRequest(std::uint64_t ticket);
    void keepSensors(bool keep);

  signals:
    void batchReady(const hedr::LiveBatch& batch);

  private:
    QThread thread_;
    LiveLink* link_;  // lives in the thread, and goes with it
};

}  // namespace hedr
