#include <algorithm>
#include <utility>

#include "app/session.h"
#include "radio/source/serial_ports.h"
#include "ui/main_window.h"

// What a program that was killed leaves, and how the next one goes on with it; all else is in
// session.cpp.
namespace hedr {

// None where it plays from its beginning again, or is gone at the next start.
std::optional<ConnectRequest> Session::wayTo(const LinkAddress& address) const {
    if (!setup_.robots_last || std::holds_alternative<RecordingAddress>(address))
        return std::nullopt;
    ConnectRequest way{.port = toText(address)};
    if (const auto* serial = std::get_if<SerialAddress>(&address)) {
        const std::vector<SerialPortEntry> ports = listSerialPorts();
        const auto adapter = std::ranges::find(ports, serial->device, &SerialPortEntry::device);
        if (adapter != ports.end()) way.identity = adapter->identity;
        way.port = serial->device;
        way.baud = serial->baud;
    }
    return way;
}

// What is recorded now, the next start goes on with, and no more with what was passed over.
void Session::noteOpenMission(const LiveBatch& batch, Connection& connection, RobotId robot) {
    if (batch.language != RobotLanguage::kUnknown) leave(std::exchange(passed_over_, {}));
    const std::string& file = batch.recorder.file;
    if (connection.note && connection.note->mission() == file) return;
    connection.note.reset();
    if (!file.empty() && connection.way)
        connection.note = std::make_unique<OpenMissionNote>(file, robot, *connection.way);
}

void Session::offerResuming() {
    interrupted_ = findInterruptedRobots();
    window_.offerResuming(resumeQuestion(interrupted_));
}

// Each over the connection that it had. Of those that cannot be reached so the operator says where
// they are, one after the other.
void Session::resume() {
    window_.offerResuming({});
    std::vector<InterruptedRobot> left;
    bool gone_on = false;
    for (InterruptedRobot& each : stillInterrupted(std::exchange(interrupted_, {}))) {
        if (goOn(each)) {
            gone_on = true;
        } else {
            left.push_back(std::move(each));
        }
    }
    if (gone_on) window_.chooseRobot(kFirstRobot);
    if (!gone_on && !left.empty()) {
        askToReach(left.front());
        left.erase(left.begin());
    }
    interrupted_ = std::move(left);
    window_.offerResuming(resumeQuestion(interrupted_));
}

bool Session::goOn(const InterruptedRobot& interrupted) {
    const ConnectRequest request = located(interrupted.request, listSerialPorts());
    if (request.port.isEmpty()) return false;
    const RobotId robot = unusedRobot();
    window_.setCallSign(robot, request.call_sign);
    resumed_[robot] = interrupted.mission.file;
    handleConnectRequest(request, robot);
    resumed_.erase(robot);
    return linkOf(robot) != nullptr;
}

void Session::askToReach(const InterruptedRobot& interrupted) {
    resumed_[unusedRobot()] = interrupted.mission.file;
    window_.askForConnection();
}

RobotId Session::unusedRobot() {
    return linkOf(window_.chosenRobot()) ? window_.addRobot() : window_.chosenRobot();
}

void Session::declineResuming() {
    resumed_.clear();
    window_.offerResuming({});
    const auto closed = decline(std::exchange(interrupted_, {}));
    if (!closed) report(closed.error());
}

}  // namespace hedr
