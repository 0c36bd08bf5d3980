#include "ui/link/link_card.h"
#include "ui/link/robot_card.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/choice_note.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/hint.h"
#include "ui/panels/legend.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/panels/status_strip.h"
#include "ui/panels/status_tiles.h"
#include "ui/site/plan_opener.h"
#include "ui/site/site_desk.h"

// What the window shows of the running mission; what it does is in main_window.cpp.
namespace hedr {
namespace {

std::vector<std::string> floorNames(const Site& site) {
    std::vector<std::string> names;
    for (const SiteFloor& floor : site.floors) names.push_back(floor.name);
    return names;
}

}  // namespace

void MainWindow::applyBatch(const LiveBatch& batch) {
    const bool was_empty = model_.trails().empty();
    if (model_.last().port == PortState::kClosed && batch.port == PortState::kOpen) {
        connect_card_->hide();
    }
    const std::optional<Error> recorder_error = model_.last().recorder.error;
    const bool key_was_good = !model_.last().key_error;
    if (!batch.restored_floors.empty()) model_.setFloorNames(floorNames(desk_->site().site()));
    model_.apply(batch, clock_.now());
    requests_.apply(batch.requests);
    if (!batch.restored_floors.empty()) desk_->site().moveRobot(model_.floor());
    if (batch.recorder.error && !recorder_error) showError(*batch.recorder.error);
    if (batch.key_error && key_was_good) showError(*batch.key_error);
    if (was_empty && !model_.trails().empty()) {
        refresh();
        if (!map_->hasPlan()) map_->fit();
    }
    map_->refresh(clock_.now());
}

void MainWindow::refresh() {
    strip_->show(statusTiles(model_, clock_.now()));
    strip_->setConnected(model_.last().port != PortState::kClosed);
    legend_->show(model_);
    if (link_card_->isVisibleTo(map_)) link_card_->show(model_);
    if (robot_card_->isVisibleTo(map_)) robot_card_->show(requests_, requestRefusal());
    link_banner_->setText(linkAdvice(model_, clock_),
                          model_.link(clock_.now()).state == LinkState::kLost
                              ? BannerTone::kAlarm
                              : BannerTone::kWarning);
    showFloorNote();
    hint_->setVisible(!map_->hasPlan() && model_.trails().empty() &&
                      !plan_progress_->isVisibleTo(map_) && !opener_->openCard());
    placeOverlays();
    map_->refresh(clock_.now());
}

void MainWindow::setTrailChoice(const TrailChoice& choice) {
    model_.setChoice(choice);
    map_->showChosenTrails();
    refresh();
}

void MainWindow::makePrimary(const std::string& trail) {
    model_.choosePrimary(trail);
    chosenAnew();
}

void MainWindow::showTrail(const std::string& trail, bool shown) {
    model_.showTrail(trail, shown);
    chosenAnew();
}

void MainWindow::chosenAnew() {
    map_->showChosenTrails();
    refresh();
    emit trailChoiceChanged(model_.choice());
}

// Before anything is driven there is no robot to lose: it will start on the floor that is shown.
void MainWindow::showFloor(std::size_t floor) {
    if (model_.trails().empty()) desk_->site().moveRobot(floor);
    map_->setFloor(floor);
    refresh();
    map_->fit();
}

void MainWindow::moveRobotTo(std::size_t floor) {
    model_.setFloor(floor);
    map_->forgetTrails();
    refresh();
}

void MainWindow::robotIsHere() {
    if (!desk_->open()) desk_->site().moveRobot(desk_->site().floorIndex());
}

void MainWindow::goToRobot() {
    desk_->site().showFloor(desk_->site().robotFloorIndex());
    map_->setFollowing(true);
}

// Trails know their floors by number: those that have some must keep theirs.
void MainWindow::removeFloor(std::size_t floor) {
    const QString name = QString::fromStdString(desk_->site().site().floors.at(floor).name);
    const bool driving = model_.last().port != PortState::kClosed || !model_.trails().empty();
    if (driving && floor <= model_.highestFloor()) {
        return showRefusal(
            tr("%1 stays: in this mission the robot has been on it, or on one above it.")
                .arg(name));
    }
    desk_->site().removeFloor(floor);
    showNote(tr("%1 is removed. Ctrl+Z brings it back.").arg(name), BannerTone::kNews);
}

void MainWindow::ask(const Request& request) { emit requestWished(++last_ticket_, request); }

void MainWindow::cancelRequests() {
    for (const std::uint64_t ticket : requests_.openTickets()) emit requestCanceled(ticket);
}

QString MainWindow::requestRefusal() const {
    const LiveBatch& last = model_.last();
    if (last.port == PortState::kClosed) return tr("Not connected to a robot.");
    if (!last.robot) return tr("The robot has not been heard yet.");
    const bool listens = (last.robot->capabilities & kCapabilityRequests) != 0;
    const bool demands = (last.robot->capabilities & kCapabilityDemandsSigned) != 0;
    if (demands && last.signing.signed_frames == 0) {
        return tr("This robot heeds signed requests only, and this computer has no key for it.");
    }
    return listens ? QString() : tr("This robot says that it takes no requests.");
}

void MainWindow::clearMission() {
    model_.clear();
    requests_.clear();
    map_->forgetTrails();
    refresh();
}

}  // namespace hedr
