#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/mission/interrupted.h"
#include "core/result.h"
#include "radio/source/serial_ports.h"
#include "ui/connect_request.h"
#include "ui/fleet.h"

namespace hedr {

// While it lives, the next start of the program finds the mission and how its robot is reached: it
// outlives a program that is killed.
class OpenMissionNote {
  public:
    OpenMissionNote(std::string mission, RobotId robot, const ConnectRequest& request);
    ~OpenMissionNote();
    OpenMissionNote(const OpenMissionNote&) = delete;
    OpenMissionNote& operator=(const OpenMissionNote&) = delete;
    const std::string& mission() const { return mission_; }
    void setRequest(const ConnectRequest& request);

  private:
    std::string mission_;
    RobotId robot_;
};

// A robot whose mission was interrupted.
struct InterruptedRobot {
    InterruptedMission mission{};
    RobotId robot = kFirstRobot;
    ConnectRequest request{};  // an empty port: nobody knows how it was reached
};

// Those whose missions a window was recording when it was killed, one for each connection, as they
// were numbered; else the newest mission of the missions' folder. None that was declined.
std::vector<InterruptedRobot> findInterruptedRobots();

// Without those that have gone on, or were closed, in another window meanwhile.
std::vector<InterruptedRobot> stillInterrupted(std::vector<InterruptedRobot> robots);

// The request with the port at which its adapter is now; without a port where that is gone.
ConnectRequest located(ConnectRequest request, const std::vector<SerialPortEntry>& ports);

// Whether they shall go on; empty for none.
QString resumeQuestion(const std::vector<InterruptedRobot>& robots);

// The operator has gone on to something else: they are left as they are.
void leave(const std::vector<InterruptedRobot>& robots);

// They are not offered again. Errors: those of closing a mission; the others are closed all the
// same.
Result<void> decline(const std::vector<InterruptedRobot>& robots);

}  // namespace hedr
