#include <algorithm>

#include "radio/source/serial_ports.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/legend.h"
#include "ui/panels/status_strip.h"
#include "ui/site/site_desk.h"

// Which robots there are, which one is chosen, and what is asked of it; how the window is made is
// in main_window.cpp.
namespace hedr {

RobotId MainWindow::addRobot() {
    FleetRobot& robot = fleet_.add();
    robot.model.setFloor(desk_->site().floorIndex());
    chooseRobot(robot.id);
    return robot.id;
}

void MainWindow::chooseRobot(RobotId robot) {
    fleet_.choose(robot);
    legend_->setTheme(inColourOf(fleet_.chosen().mark, theme_));
    desk_->site().turnToRobotOn(model().floor());
    if (map_->following() && !desk_->open()) desk_->site().showFloor(model().floor());
    map_->showChosenTrails();
    refresh();
}

void MainWindow::setCallSign(RobotId robot, const QString& call_sign) {
    if (FleetRobot* named = fleet_.find(robot)) named->call_sign = call_sign;
    refresh();
}

void MainWindow::chooseNextRobot() {
    if (const FleetRobot* next = fleet_.next()) chooseRobot(next->id);
}

// A robot that was never connected is the one that is meant.
void MainWindow::connectAnother() {
    const bool unused = model().last().port == PortState::kClosed && model().trails().empty();
    if (!unused) {
        addRobot();
        connect_card_->propose({});
    }
    askForConnection();
}

void MainWindow::removeRobot(RobotId robot) {
    fleet_.remove(robot);
    if (fleet_.find(robot)) return;  // it is connected
    emit robotRemoved(robot);
    chooseRobot(fleet_.chosen().id);
}

void MainWindow::proposeConnection(const ConnectRequest& earlier) {
    connect_card_->propose(earlier);
}

void MainWindow::askForConnection() {
    if (!connect_card_->isVisibleTo(map_)) toggleConnection();
}

void MainWindow::toggleConnection() {
    if (model().last().port != PortState::kClosed) {
        emit disconnectRequested(fleet_.chosen().id);
        return;
    }
    connect_card_->setPorts(freePorts());
    toggleCard(connect_card_);
}

// Those over which no robot is connected yet.
std::vector<SerialPortEntry> MainWindow::freePorts() const {
    std::vector<SerialPortEntry> ports = listSerialPorts();
    std::erase_if(ports, [this](const SerialPortEntry& port) {
        return std::ranges::any_of(fleet_.robots(), [&](const FleetRobot& robot) {
            const LiveBatch& last = robot.model.last();
            const auto* serial = std::get_if<SerialAddress>(&last.address);
            return last.port != PortState::kClosed && serial && serial->device == port.device;
        });
    });
    return ports;
}

void MainWindow::ask(const Request& request) {
    emit requestWished(++last_ticket_, request, fleet_.chosen().id);
}

void MainWindow::cancelRequests() {
    for (const std::uint64_t ticket : fleet_.chosen().requests.openTickets()) {
        emit requestCanceled(ticket, fleet_.chosen().id);
    }
}

QString MainWindow::requestRefusal() const {
    const LiveBatch& last = fleet_.chosen().model.last();
    if (last.port == PortState::kClosed) return tr("Not connected to a robot.");
    if (!last.robot) return tr("The robot has not been heard yet.");
    if (fleet_.chosen().model.link(clock_.now()).state == LinkState::kLost)
        return tr("The robot is not heard now.");
    const bool listens = (last.robot->capabilities & kCapabilityRequests) != 0;
    const bool demands = (last.robot->capabilities & kCapabilityDemandsSigned) != 0;
    if (demands && last.signing.signed_frames == 0) {
        return tr("This robot heeds signed requests only, and this computer has no key for it.");
    }
    return listens ? QString() : tr("This robot says that it takes no requests.");
}

void MainWindow::clearMission(RobotId id) {
    FleetRobot* robot = fleet_.find(id);
    if (!robot) return;
    robot->model.clear();
    robot->requests.clear();
    map_->forgetTrails();
    refresh();
}

}  // namespace hedr
