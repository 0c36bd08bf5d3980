#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "radio/link/robot_write.h"
#include "radio/live_batch.h"

namespace hedr {

// Gives one robot several parameters, all of them or none, over its link: asks, hears what came of
// it with the batches, and puts back what was there where one fails. Where the link is lost it does
// that when the robot is heard again.
class RobotWriter : public QObject {
    Q_OBJECT

  public:
    using Ask = std::function<void(std::uint64_t ticket, const Request& request)>;

    // `ask`: of the robot's link, while it has one.
    RobotWriter(const std::vector<ParameterSet>& wishes, Ask ask, QObject* parent = nullptr);

    void start();
    void hear(const LiveBatch& batch);

  signals:
    void linkMissed();               // once; what was there is put back later
    void ended(const QString& why);  // empty: the robot has all of them; else none, and why

  private:
    void goOn();

    RobotWrite write_;
    Ask ask_;
    std::uint64_t last_ticket_;
    bool told_missing_ = false;
};

}  // namespace hedr
