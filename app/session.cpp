#include "app/session.h"

#include <QApplication>
#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <utility>

#include "app/mission_files.h"
#include "app/settings_store.h"
#include "core/site/plan.h"
#include "radio/live_link.h"
#include "radio/robot_key.h"
#include "ui/error_text.h"
#include "ui/main_window.h"
#include "ui/site/site_desk.h"

namespace hedr {
namespace {

// For whoever started the program from a script; the window shows them all.
void sayToScripts(const Error& error) {
    std::cerr << "hedr-ocu: " << errorText(error).toStdString() << '\n';
}

}  // namespace

Session::Session(MainWindow& window, Setup setup, QObject* parent)
    : QObject(parent),
      window_(window),
      setup_(std::move(setup)),
      keeper_(window, this),
      copier_(window, this),
      publishing_(this) {
    joinWindow();
    joinKeeper();
    joinCalibration();
    const StoredSettings settings = loadSettings();
    window_.setRecentPlans(settings.recent_plans);
    window_.proposeConnection(settings.connection);
}

Session::~Session() = default;

void Session::joinWindow() {
    connect(&window_, &MainWindow::connectRequested, this, &Session::handleConnectRequest);
    connect(&window_, &MainWindow::disconnectRequested, this, [this](RobotId robot) {
        if (RobotLink* link = linkOf(robot)) link->close();
    });
    connect(&window_, &MainWindow::robotRemoved, this, [this](RobotId robot) {
        connections_.erase(robot);
        setPace();
    });
    connect(&window_, &MainWindow::linkLost, &QApplication::beep);
    connect(&window_, &MainWindow::resumeWished, this, &Session::resume);
    connect(&window_, &MainWindow::resumeDeclined, this, &Session::declineResuming);
    connect(&window_, &MainWindow::requestWished, this,
            [this](quint64 ticket, const Request& wish, RobotId robot) {
                if (RobotLink* link = linkOf(robot)) link->ask(ticket, wish);
            });
    connect(&window_, &MainWindow::requestCanceled, this, [this](quint64 ticket, RobotId robot) {
        if (RobotLink* link = linkOf(robot)) link->cancelRequest(ticket);
    });
    const SiteModel& site = window_.desk().site();
    connect(&site, &SiteModel::kept, this, &Session::noteSite);
    connect(&site, &SiteModel::robotMoved, this, &Session::noteRobotFloor);
}

void Session::joinKeeper() {
    connect(&window_, &MainWindow::planFileChosen, &keeper_, &SiteKeeper::open);
    connect(&window_, &MainWindow::planLoadCanceled, &keeper_, &SiteKeeper::cancel);
    connect(&window_, &MainWindow::siteFileChosen, &keeper_,
            [this](const QString& file) { keeper_.saveAs(file.toStdString()); });
    connect(&keeper_, &SiteKeeper::opened, this, [this](const PlanFileWish& wish) {
        if (wish.lasting) rememberInList(wish.file);
    });
    connect(&keeper_, &SiteKeeper::saved, this, [this](const QString& file) {
        rememberInList(file);
        window_.showSaved({file.toStdString()});
    });
    connect(&copier_, &PlanCopier::failed, this, &Session::report);
    connect(&keeper_, &SiteKeeper::imageAdded, this, &Session::notePlan);
    connect(&keeper_, &SiteKeeper::failed, this, &Session::report);
    connect(&window_, &MainWindow::publishWished, this, &Session::publishTo);
    connect(&publishing_, &Publishing::failed, this, &Session::report);
    connect(&publishing_, &Publishing::stateChanged, this,
            [this] { window_.showPublishing(publishing_.states()); });
    connect(&publish_timer_, &QTimer::timeout, this, &Session::publishPoses);
}

RobotLink* Session::linkOf(RobotId robot) const {
    const auto found = connections_.find(robot);
    return found == connections_.end() ? nullptr : found->second.link.get();
}

void Session::handleConnectRequest(const ConnectRequest& request, RobotId robot) {
    std::optional<Vehicle> vehicle = setup_.vehicle;
    if (!request.vehicle_file.isEmpty()) {
        const auto loaded = loadVehicle(request.vehicle_file.toStdString());
        if (!loaded) return report(loaded.error());
        vehicle = *loaded;
    }
    for (const Vehicle& preset : vehiclePresets()) {
        if (request.vehicle_preset == QString::fromStdString(preset.name)) vehicle = preset;
    }
    auto address = parseLinkAddress(request.port);
    if (!address) return report(address.error());
    auto* serial = std::get_if<SerialAddress>(&*address);
    if (serial && serial->baud == SerialAddress::kFindOut) serial->baud = request.baud;
    connections_[robot].asked = request;
    connections_[robot].calibrations.clear();
    // What is calibrated goes into the file whose vehicle it is, and into no other.
    connections_[robot].vehicle_file =
        !request.vehicle_file.isEmpty() ? std::filesystem::path(request.vehicle_file.toStdString())
        : request.vehicle_preset.isEmpty() ? setup_.vehicle_file
                                           : std::filesystem::path();
    connectTo(*address, vehicle, robot);
}

void Session::connectTo(const LinkAddress& address, const std::optional<Vehicle>& vehicle,
                        RobotId robot) {
    Connection& connection = connections_[robot];
    dropWriter(connection);
    connection.link.reset();
    connection.way = wayTo(address);
    if (connection.way && connection.asked) connection.way = connection.asked;
    if (!resumed_.contains(robot)) {
        std::ranges::move(std::exchange(interrupted_, {}), std::back_inserter(passed_over_));
        window_.offerResuming({});
    }
    window_.clearMission(robot);
    startLink(vehicle, robot);
    connection.link->open(address);
}

void Session::connectToAll(const QStringList& ports) {
    for (const QString& port : ports) {
        const RobotId robot = port == ports.front() ? window_.chosenRobot() : window_.addRobot();
        if (const auto address = parseLinkAddress(port)) {
            connections_[robot].vehicle_file = setup_.vehicle_file;
            connectTo(*address, setup_.vehicle, robot);
        } else {
            report(address.error());
        }
    }
    window_.chooseRobot(kFirstRobot);
}

void Session::publishTo(const std::vector<PublishTarget>& targets) {
    constexpr int kPublish_ms = 50;  // twice as often as the fastest of the targets is told
    publishing_.setTargets(targets);
    window_.showPublishing(publishing_.states());
    targets.empty() ? publish_timer_.stop() : publish_timer_.start(kPublish_ms);
}

void Session::publishPoses() {
    const Fleet& fleet = window_.fleet();
    const ReceiveClock::time_point now = ReceiveClock::now();
    std::vector<PublishedPose> poses;
    poses.reserve(fleet.size());
    for (const FleetRobot& robot : fleet.robots()) {
        auto pose = poseToPublish(robot.model, fleet.callSign(robot).toStdString(),
                                  window_.desk().site().site(), now);
        if (!pose) continue;
        pose->chosen = &robot == &fleet.chosen();
        poses.push_back(std::move(*pose));
    }
    publishing_.publish(std::move(poses));
}

// The missions of further robots lie beside the one that was named, numbered.
std::filesystem::path Session::missionFileOf(RobotId robot) {
    if (const auto resumed = resumed_.extract(robot)) return resumed.mapped();
    if (setup_.mission.empty()) return newMissionFile(robot);
    if (robot == kFirstRobot) return setup_.mission;
    std::filesystem::path file = setup_.mission;
    std::string name = file.stem().string();
    name.append("-").append(std::to_string(robot)).append(file.extension().string());
    return file.replace_filename(name);
}

void Session::startLink(const std::optional<Vehicle>& vehicle, RobotId robot) {
    const QString version =
        QCoreApplication::applicationName() + ' ' + QCoreApplication::applicationVersion();
    LiveLink::Setup setup;
    setup.vehicle = vehicle;
    setup.mission = missionFileOf(robot);
    setup.header.start = std::chrono::system_clock::now();
    setup.header.program_version = version.toStdString();
    setup.keys = defaultKeyFolder();
    Connection& connection = connections_[robot];
    connection.link = std::make_unique<RobotLink>(setup);
    connect(connection.link.get(), &RobotLink::batchReady, this,
            [this, robot](const LiveBatch& batch) { handleBatch(batch, robot); });
    setPace();
    if (sampled_ == robot) connection.link->keepSensors(true);
    if (plan_) connection.link->notePlan(*plan_);
    if (site_) connection.link->noteSite(*site_);
    const bool upstairs = window_.desk().site().robotFloorIndex() > 0;
    if (robot == window_.chosenRobot() && (connection.floor_said || upstairs)) noteRobotFloor();
}

void Session::setPace() {
    for (const auto& [robot, connection] : connections_) {
        if (connection.link) connection.link->setFramePeriod(window_.fleet().framePeriod());
    }
}

void Session::noteSite(const Site& site) {
    site_ = site;
    for (const auto& [robot, connection] : connections_) {
        if (connection.link) connection.link->noteSite(site);
    }
}

void Session::noteRobotFloor() {
    Connection& connection = connections_[window_.chosenRobot()];
    connection.floor_said = true;
    const SiteModel& site = window_.desk().site();
    const std::string& name = site.site().floors.at(site.robotFloorIndex()).name;
    if (connection.link) connection.link->noteFloor(name);
}

void Session::handleBatch(const LiveBatch& batch, RobotId robot) {
    Connection& connection = connections_[robot];
    tell(batch.port_error, connection.told_port);
    tell(batch.recorder.error, connection.told_recorder);
    tell(batch.key_error, connection.told_key);
    for (const Error& warning : batch.warnings) sayToScripts(warning);
    if (batch.restored_site) restoreSite(*batch.restored_site);
    rememberWhatWorked(batch, connection);
    noteOpenMission(batch, connection, robot);
    window_.applyBatch(batch, robot);
    if (connection.writer) connection.writer->hear(batch);
}

// A robot is heard: the next time this connection is proposed, with the baud rate that was found.
void Session::rememberWhatWorked(const LiveBatch& batch, Connection& connection) {
    if (!connection.asked || batch.language == RobotLanguage::kUnknown) return;
    if (const auto* serial = std::get_if<SerialAddress>(&batch.address))
        connection.asked->baud = serial->baud;
    rememberConnection(*connection.asked);
    if (connection.way) connection.way = connection.asked;
    if (connection.note) connection.note->setRequest(*connection.asked);
    window_.proposeConnection(*connection.asked);
    connection.asked.reset();
}

void Session::tell(const std::optional<Error>& error, std::optional<ErrorCode>& told) {
    const std::optional<ErrorCode> code = error ? std::optional(error->code) : std::nullopt;
    if (std::exchange(told, code) == code || !error) return;
    sayToScripts(*error);
}

void Session::notePlan(const PlanImage& plan) {
    plan_ = MissionPlan{plan.image_file, plan.placement, std::nullopt};
    for (const auto& [robot, connection] : connections_) {
        if (connection.link) connection.link->notePlan(*plan_);
    }
}

// A mission that goes on brings its site with it, unless the operator has opened another one.
void Session::restoreSite(const Site& site) {
    const auto empty = [](const SiteFloor& floor) { return floor.plans.empty(); };
    if (!std::ranges::all_of(window_.desk().site().site().floors, empty)) return;
    site_ = site;
    keeper_.openSite(site, {});
}

void Session::rememberInList(const QString& file) { window_.setRecentPlans(rememberPlan(file)); }

void Session::report(const Error& error) {
    sayToScripts(error);
    window_.showError(error);
}

}  // namespace hedr
