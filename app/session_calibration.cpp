#include "app/calibration_keeper.h"
#include "app/session.h"
#include "app/settings_store.h"
#include "core/calibration/history/surface_profile.h"
#include "radio/link/robot_parameters.h"
#include "ui/calibration/calibration_desk.h"
#include "ui/calibration/history_page.h"
#include "ui/error_text.h"
#include "ui/main_window.h"

// What the session does for the calibration of a robot; the rest is in session.cpp.
namespace hedr {

void Session::joinCalibration() {
    connect(&window_, &MainWindow::calibrationWished, this, [this](RobotId robot) {
        const auto history = loadHistory(historyFolderOf(vehicleFileOf(robot)))
                                 .value_or(std::vector<HistoryEntry>{});
        window_.chooseCalibration({.last = lastCalibrations(history),
                                   .kept = history.size(),
                                   .surfaces = surfaceProfiles(history),
                                   .since_connected = connections_[robot].calibrations});
    });
    connect(&window_, &MainWindow::samplesWished, this, [this](bool wished, RobotId robot) {
        sampled_ = wished ? std::optional(robot) : std::nullopt;
        if (RobotLink* link = linkOf(robot)) link->keepSensors(wished);
    });
    connect(&window_, &MainWindow::calibrationConcluded, this, &Session::keepCalibration);
    connect(&window_, &MainWindow::historyWished, this,
            [this](RobotId robot) { showHistory(robot, {}); });
    connect(&window_, &MainWindow::restoreWished, this, &Session::restore);
    connect(&window_, &MainWindow::exportWished, this, &Session::exportCalibration);
}

std::filesystem::path Session::vehicleFileOf(RobotId robot) const {
    const auto connection = connections_.find(robot);
    if (connection != connections_.end() && !connection->second.vehicle_file.empty())
        return connection->second.vehicle_file;
    const FleetRobot* of = window_.fleet().find(robot);
    if (!of || !of->model.last().robot) return ownVehicleFile("");
    const LiveBatch& last = of->model.last();
    std::string name = last.robot->vehicle;
    // Where the language tells no name, many are called the same: by the way to it, then.
    if (last.language != RobotLanguage::kHedr && connection != connections_.end() &&
        connection->second.way) {
        const ConnectRequest& way = *connection->second.way;
        name += ' ' + (way.identity.isEmpty() ? way.port : way.identity).toStdString();
    }
    return ownVehicleFile(name);
}

// The samples may be hours.
void Session::keepCalibration(const CalibrationOutcome& outcome, RobotId robot) {
    const std::filesystem::path file = vehicleFileOf(robot);
    keeping_.start(
        [file, outcome](const PlanProgress&) { return keepOutcome(file, outcome); },
        [this, file, robot, outcome](const Result<KeptCalibration>& kept) {
            tellKept(kept, file, robot);
            if (kept && kept->taken_over)
                connections_[robot].calibrations.push_back(outcome.calibration);
            if (kept && kept->taken_over && outcome.for_robot)
                writeToRobot(robotParametersIn(outcome.calibration, outcome.input.vehicle), robot);
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

void Session::showHistory(RobotId robot, const QString& news) {
    const std::filesystem::path file = vehicleFileOf(robot);
    auto history = loadHistory(historyFolderOf(file));
    if (!history) report(history.error());
    const auto now = loadVehicle(file);
    const FleetRobot* of = window_.fleet().find(robot);
    window_.showHistory({.robot = of ? window_.fleet().callSign(*of) : QString(),
                         .vehicle_file = QString::fromStdString(file.string()),
                         .entries = history ? std::move(*history) : std::vector<HistoryEntry>(),
                         .now = now ? std::optional(*now) : std::nullopt,
                         .news = history ? news : errorText(history.error())});
}

void Session::restore(const QString& entry, RestoreTo to, RobotId robot) {
    const std::filesystem::path file = vehicleFileOf(robot);
    const auto restored =
        historyEntry(historyFolderOf(file), entry.toStdString()).and_then([&](const auto& of) {
            return restoreCalibration(file, of, to);
        });
    if (!restored) return showHistory(robot, errorText(restored.error()));
    proposeVehicle(file, robot);
    showHistory(robot, tr("The vehicle file has these values; they count from the next "
                          "connection. What it had is kept."));
}

// Its samples may be hours.
void Session::exportCalibration(const QString& entry, const QString& folder, RobotId robot) {
    const std::filesystem::path history = historyFolderOf(vehicleFileOf(robot));
    const std::filesystem::path target =
        std::filesystem::path(folder.toStdString()) / entry.toStdString();
    showHistory(robot, tr("Copying…"));
    exporting_.start(
        [history, name = entry.toStdString(), target](const PlanProgress&) {
            return historyEntry(history, name).and_then([&](const HistoryEntry& of) {
                return exportEntry(of, target);
            });
        },
        [this, robot, target](const Result<void>& copied) {
            const QString done = tr("Copied to %1.").arg(QString::fromStdString(target.string()));
            if (window_.showsHistory())
                return showHistory(robot, copied ? done : errorText(copied.error()));
            copied ? window_.showNews(done) : report(copied.error());
        });
}

// The vehicle file has them whatever comes of it here.
void Session::writeToRobot(const std::vector<ParameterSet>& wishes, RobotId robot) {
    Connection& connection = connections_[robot];
    if (connection.writer && !connection.writer->over()) {
        return window_.showTrouble(
            tr("The robot is still being given its earlier values. The vehicle file has the new "
               "ones; write them again when that is done."));
    }
    connection.writer = std::make_unique<RobotWriter>(
        wishes, [this, robot](std::uint64_t ticket, const Request& request) {
            if (RobotLink* link = linkOf(robot)) link->ask(ticket, request);
        });
    RobotWriter* writer = connection.writer.get();
    connect(writer, &RobotWriter::delayed, this, [this](const QString& why) {
        window_.showTrouble(
            tr("%1 It may have a part of the new values, and gets back what it had as soon as it "
               "takes them.")
                .arg(why));
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

// The next link may lead to another robot, which must not get what was meant for this one.
void Session::dropWriter(Connection& connection) {
    if (connection.writer && !connection.writer->over()) {
        window_.showTrouble(
            tr("The robot that was being written to may have a part of its new values. Connect to "
               "it again and write them once more."));
    }
    connection.writer.reset();
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
