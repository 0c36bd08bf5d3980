#include "app/session.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QStandardPaths>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

#include "app/settings_store.h"
#include "core/site/plan.h"
#include "radio/live_link.h"
#include "radio/robot_key.h"
#include "ui/error_text.h"
#include "ui/format.h"
#include "ui/main_window.h"
#include "ui/site/site_desk.h"

namespace hedr {

Session::Session(MainWindow& window, Setup setup, QObject* parent)
    : QObject(parent),
      window_(window),
      setup_(std::move(setup)),
      keeper_(window, this),
      copier_(window, this),
      radio_thread_(this) {
    qRegisterMetaType<LiveBatch>();
    qRegisterMetaType<LinkAddress>();
    qRegisterMetaType<MissionPlan>();
    qRegisterMetaType<Request>();
    connect(&window_, &MainWindow::connectRequested, this, &Session::handleConnectRequest);
    connect(&window_, &MainWindow::disconnectRequested, this, &Session::disconnectLink);
    connect(&window_, &MainWindow::resumeWished, this, &Session::resume);
    connect(&window_, &MainWindow::resumeDeclined, this, &Session::declineResuming);
    connect(&window_, &MainWindow::requestWished, this,
            [this](quint64 ticket, const Request& wish) {
                if (!link_) return;
                QMetaObject::invokeMethod(
                    link_, [link = link_, ticket, wish] { link->ask(ticket, wish); });
            });
    connect(&window_, &MainWindow::requestCanceled, this, [this](quint64 ticket) {
        if (!link_) return;
        QMetaObject::invokeMethod(link_, [link = link_, ticket] { link->cancelRequest(ticket); });
    });
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
    const SiteModel& site = window_.desk().site();
    connect(&site, &SiteModel::kept, this, &Session::noteSite);
    connect(&site, &SiteModel::robotMoved, this, &Session::noteRobotFloor);
    const StoredSettings settings = loadSettings();
    window_.setRecentPlans(settings.recent_plans);
    window_.proposeConnection(settings.connection);
    radio_thread_.setObjectName("radio");
}

Session::~Session() { stopLink(); }

void Session::handleConnectRequest(const ConnectRequest& request) {
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
    asked_ = request;
    connectTo(*address, vehicle);
}

void Session::connectTo(const LinkAddress& address, const std::optional<Vehicle>& vehicle) {
    stopLink();
    interrupted_.reset();  // another mission begins, or that one goes on
    window_.offerResuming({});
    window_.clearMission();
    startLink(vehicle);
    QMetaObject::invokeMethod(link_, [link = link_, address] { link->open(address); });
}

void Session::startLink(const std::optional<Vehicle>& vehicle) {
    const std::filesystem::path mission =
        resumed_.empty() ? (setup_.mission.empty() ? newMissionFile() : setup_.mission) : resumed_;
    resumed_.clear();
    const QString version =
        QCoreApplication::applicationName() + ' ' + QCoreApplication::applicationVersion();
    link_ = new LiveLink({.vehicle = vehicle,
                          .mission = mission,
                          .header = {.start = std::chrono::system_clock::now(),
                                     .program_version = version.toStdString()},
                          .keys = defaultKeyFolder()});
    link_->moveToThread(&radio_thread_);
    connect(&radio_thread_, &QThread::finished, link_, &QObject::deleteLater);
    connect(link_, &LiveLink::batchReady, this,
            [this](const LiveBatch& batch) { handleBatch(batch); });
    radio_thread_.start();
    if (plan_) {
        QMetaObject::invokeMethod(link_, [link = link_, plan = *plan_] { link->notePlan(plan); });
    }
    if (site_) noteSite(*site_);
    if (floor_said_) noteRobotFloor();
}

void Session::noteSite(const Site& site) {
    site_ = site;
    if (link_) QMetaObject::invokeMethod(link_, [link = link_, site] { link->noteSite(site); });
}

void Session::noteRobotFloor() {
    floor_said_ = true;
    const SiteModel& site = window_.desk().site();
    const std::string& name = site.site().floors.at(site.robotFloorIndex()).name;
    if (link_) QMetaObject::invokeMethod(link_, [link = link_, name] { link->noteFloor(name); });
}

// The window shows every error; a script that started the program reads it on standard error.
void Session::handleBatch(const LiveBatch& batch) {
    tell(batch.port_error, told_port_);
    tell(batch.recorder.error, told_recorder_);
    tell(batch.key_error, told_key_);
    if (batch.restored_site) restoreSite(*batch.restored_site);
    rememberWhatWorked(batch);
    window_.applyBatch(batch);
}

// A robot is heard: the next time this connection is proposed, with the baud rate that was found.
void Session::rememberWhatWorked(const LiveBatch& batch) {
    if (!asked_ || batch.language == RobotLanguage::kUnknown) return;
    if (const auto* serial = std::get_if<SerialAddress>(&batch.address))
        asked_->baud = serial->baud;
    rememberConnection(*asked_);
    window_.proposeConnection(*asked_);
    asked_.reset();
}

void Session::tell(const std::optional<Error>& error, std::optional<ErrorCode>& told) {
    const std::optional<ErrorCode> code = error ? std::optional(error->code) : std::nullopt;
    if (std::exchange(told, code) == code || !error) return;
    std::cerr << "hedr-ocu: " << errorText(*error).toStdString() << '\n';
}

void Session::stopLink() {
    radio_thread_.quit();
    radio_thread_.wait();
    link_ = nullptr;
}

void Session::offerResuming() {
    interrupted_ = findInterrupted(missionsFolder());
    if (!interrupted_) return;
    const QDateTime start =
        QDateTime::fromMSecsSinceEpoch(std::chrono::duration_cast<std::chrono::milliseconds>(
                                           interrupted_->info.start.time_since_epoch())
                                           .count());
    const bool today = start.date() == QDate::currentDate();
    window_.offerResuming(tr("The mission of %1 was interrupted after %2. Go on with it?")
                              .arg(start.toString(today ? "HH:mm" : "yyyy-MM-dd HH:mm"),
                                   formatDuration(interrupted_->info.duration_s)));
}

// Over the connection of last time; where there was none, the operator says which.
void Session::resume() {
    resumed_ = interrupted_->file;
    const ConnectRequest earlier = loadSettings().connection;
    if (earlier.port.isEmpty()) return window_.askForConnection();
    handleConnectRequest(earlier);
}

void Session::declineResuming() {
    resumed_.clear();
    window_.offerResuming({});
    const auto closed = closeInterrupted(interrupted_->file);
    interrupted_.reset();
    if (!closed) report(closed.error());
}

void Session::disconnectLink() {
    if (link_) QMetaObject::invokeMethod(link_, &LiveLink::close);
}

void Session::notePlan(const PlanImage& plan) {
    plan_ = MissionPlan{plan.image_file, plan.placement, std::nullopt};
    if (link_) {
        QMetaObject::invokeMethod(link_, [link = link_, noted = *plan_] { link->notePlan(noted); });
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

// Also on standard error, for whoever started the program from a script.
void Session::report(const Error& error) {
    std::cerr << "hedr-ocu: " << errorText(error).toStdString() << '\n';
    window_.showError(error);
}

std::filesystem::path missionsFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return (data + "/missions").toStdString();
}

std::filesystem::path newMissionFile() {
    const QDir folder(QString::fromStdString(missionsFolder().string()));
    (void)folder.mkpath(".");
    const QString moment = QDateTime::currentDateTime().toString("yyyy-MM-dd'T'HH-mm-ss");
    QString name = moment + ".hedr";
    // A clock that was set back, or a second window, must not continue another mission.
    for (int i = 2; folder.exists(name); ++i) name = moment + '-' + QString::number(i) + ".hedr";
    return folder.filePath(name).toStdString();
}

}  // namespace hedr
