#include "app/calibration_keeper.h"
#include "app/session.h"
#include "app/settings_store.h"
#include "core/calibration/history/surface_profile.h"
#include "radio/link/robot_parameters.h"
#include "ui/calibration/calibration_desk.h"
#include "ui/main_window.h"

// What the session does for the calibration of a robot; the rest is in session.cpp.
namespace hedr {

void Session::joinCalibration() {
    connect(&window_, &MainWindow::calibrationWished, this, [this](RobotId robot) {
        const auto history = loadHistory(historyFolderOf(vehicleFileOf(robot)))
                                 .value_or(std::vector<HistoryEntry>{});
        window_.chooseCalibration({.last = lastCalibrations(history),
                                   .surfaces = surfaceProfiles(history),
                                   .since_connected = connections_[robot].calibrations});
    });
    connect(&window_, &MainWindow::samplesWished, this, [this](bool wished, RobotId robot) {
        sampled_ = wished ? std::optional(robot) : std::nullopt;
        if (RobotLink* link = linkOf(robot)) link->keepSensors(wished);
    });
    connect(&window_, &MainWindow::calibrationConcluded, this, &Session::keepCalibration);
}

std::filesystem::path Session::vehicleFileOf(RobotId robot) const {
    const auto connection = connections_.find(robot);
    if (connection != connections_.end() && !connection->second.vehicle_file.empty())
        return connection->second.vehicle_file;
    if (!setup_.vehicle_file.empty()) return setup_.vehicle_file;
    const FleetRobot* of = window_.fleet().find(robot);
    return ownVehicleFile(of && of->model.last().robot ? of->model.last().robot->vehicle : "");
}

// The samples may be hours.
void Session::keepCalibration(const CalibrationOutcome& outcome, RobotId robot) {
    const std::filesystem::path file = vehicleFileOf(robot);
    keeping_.start([file, outcome](const PlanProgress&) { return keepOutcome(file, outcome); },
                   [this, file, robot, outcome](const Result<KeptCalibration>& kept) {
                       tellKept(kept, file, robot);
                       if (kept && kept->taken_over)
                           connections_[robot].calibrations.push_back(outcome.calibration);
                       if (kept && kept->taken_over && outcome.for_robot)
                           writeToRobot(robotParametersIn(outcome.calibration), robot);
                   });
}

void Session::tellKept(const Result<KeptCalibration>& kept, const std::filesystem::path& file,
                       RobotId robot) {
    if (!kept) return report(kept.error());
    const QString name = QString::fromStdString(file.string());
    if (!kept->taken_over) return window_.showNews(tr("Kept in the history of %1.").arg(name));
    proposeVehicle(file, robot);
    window_.showNews(
        tr("Kept. %1 has the new values; they count from the next connection.").arg(name));
}

// The vehicle file has them whatever comes of it here.
void Session::writeToRobot(const std::vector<ParameterSet>& wishes, RobotId robot) {
    Connection& connection = connections_[robot];
    connection.writer = std::make_unique<RobotWriter>(
        wishes, [this, robot](std::uint64_t ticket, const Request& request) {
            if (RobotLink* link = linkOf(robot)) link->ask(ticket, request);
        });
    RobotWriter* writer = connection.writer.get();
    connect(writer, &RobotWriter::linkMissed, this, [this] {
        window_.showTrouble(
            tr("The robot is not heard, and may have a part of the new values. It gets back what "
               "it had as soon as it is heard again."));
    });
    connect(writer, &RobotWriter::ended, this, [this](const QString& why) {
        why.isEmpty() ? window_.showNews(tr("Kept, and the robot has the new values."))
                      : window_.showTrouble(
                            tr("The robot has its old values. %1 The vehicle file has the new "
                               "ones; write them again when the robot is well heard.")
                                .arg(why));
    });
    writer->start();
}

void Session::proposeVehicle(const std::filesystem::path& file, RobotId robot) {
    Connection& connection = connections_[robot];
    connection.vehicle_file = file;
    if (!connection.way) return;
    connection.way->vehicle_preset.clear();
    connection.way->vehicle_file = QString::fromStdString(file.string());
    rememberConnection(*connection.way);
    window_.proposeConnection(*connection.way);
    if (connection.note) connection.note->setRequest(*connection.way);
}

}  // namespace hedr
