#pragma once

#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "radio/replay.h"
#include "tests/radio/spoken_drive.h"

namespace hedr {

// A robot on a pseudo-terminal that talks until it is told to stop.
class TalkingRobot {
  public:
    TalkingRobot(const QString& port, double seconds, const ReplayScript& script)
        : TalkingRobot(port, straightDrive(seconds), script) {}
    TalkingRobot(const QString& port, const std::vector<SensorReport>& reports,
                 const ReplayScript& script)
        : line_(std::make_unique<RobotLine>(
              RobotLine::openPseudoTerminal(port.toStdString()).value())),
          thread_([this, reports, script] {
              SimulatedRobot robot(spokenVehicle(), {});
              const auto stopped = [this] { return stop_.load(); };
              waitForListener(*line_, stopped);
              replayReports(reports, robot, *line_, script, stopped);
              done_ = true;
          }) {}
    ~TalkingRobot() {
        stop_ = true;
        thread_.join();
    }
    bool done() const { return done_; }

  private:
    std::unique_ptr<RobotLine> line_;
    std::atomic<bool> stop_{false};
    std::atomic<bool> done_{false};
    std::thread thread_;
};

}  // namespace hedr
