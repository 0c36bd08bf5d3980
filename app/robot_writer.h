#pragma once

#include <QObject>
#include <QTimer>
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
    bool over() const { return write_.over(); }
    void hear(const LiveBatch& batch);

  signals:
    // Once: what was there is put back later, and why not now.
    void delayed(const QString& why);
    void ended(const QString& why);  // empty: the robot has all of them; else none, and why

  private:
    void goOn();

    RobotWrite write_;
    Ask ask_;
    std::uint64_t last_ticket_;
    bool told_delay_ = false;
    QTimer pause_;  // before a robot that refused is asked again
};

}  // namespace hedr
