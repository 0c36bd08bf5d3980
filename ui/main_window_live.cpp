#include <algorithm>
#include <chrono>

#include "ui/calibration/calibration_desk.h"
#include "ui/link/link_advice.h"
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
#include "ui/panels/robots_card.h"
#include "ui/panels/status_strip.h"
#include "ui/panels/status_tiles.h"
#include "ui/publish/publish_card.h"
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

void MainWindow::applyBatch(const LiveBatch& batch, RobotId id) {
    FleetRobot* robot = fleet_.find(id);
    if (!robot) return;  // it was removed meanwhile
    const bool is_chosen = robot == &fleet_.chosen();
    LiveModel& of_robot = robot->model;
    const bool was_empty = of_robot.trails().empty();
    if (is_chosen && of_robot.last().port == PortState::kClosed && batch.port == PortState::kOpen) {
        connect_card_->hide();
    }
    const std::optional<Error> recorder_error = of_robot.last().recorder.error;
    const bool key_was_good = !of_robot.last().key_error;
    if (id == calibrated_) calibration_->take(batch.sensors);
    if (!batch.restored_floors.empty()) of_robot.setFloorNames(floorNames(desk_->site().site()));
    of_robot.apply(batch, clock_.now());
    robot->requests.apply(batch.requests);
    if (is_chosen && !batch.restored_floors.empty()) desk_->site().moveRobot(of_robot.floor());
    if (batch.recorder.error && !recorder_error) showError(*batch.recorder.error);
    for (const Error& warning : batch.warnings) showWarning(warning, *robot);
    if (batch.key_error && key_was_good) showError(*batch.key_error);
    if (was_empty && !of_robot.trails().empty()) {
        refresh();
        if (!map_->hasPlan()) map_->fit();
    }
    refreshMapOnceAFrame();
}

// Batches of several robots come at any moment: the map is drawn once a frame all the same.
void MainWindow::refreshMapOnceAFrame() {
    constexpr std::chrono::milliseconds kJitter{1};  // of batches that come once a frame
    const auto frame = fleet_.framePeriod() - kJitter;
    if (map_timer_.isActive()) return;
    const auto since = clock_.now() - map_refreshed_;
    if (since >= frame) return refreshMap();
    map_timer_.start(std::chrono::ceil<std::chrono::milliseconds>(frame - since));
}

void MainWindow::refreshMap() {
    map_refreshed_ = clock_.now();
    map_->refresh(map_refreshed_);
}

void MainWindow::refresh() {
    showStrip();
    robots_card_->show(robotEntries(fleet_, clock_.now()));
    const QString whose = fleet_.several() ? fleet_.callSign(fleet_.chosen()) : QString();
    legend_->show(fleet_.chosen(), whose);
    if (link_card_->isVisibleTo(map_)) link_card_->show(model(), whose);
    if (robot_card_->isVisibleTo(map_)) {
        robot_card_->show(fleet_.chosen().requests, whose, requestRefusal());
    }
    calibration_->sayLink(samplesTrouble());
    showLinkAdvice();
    soundAlarms();
    showFloorNote();
    hint_->setVisible(!map_->hasPlan() && model().trails().empty() &&
                      !plan_progress_->isVisibleTo(map_) && !opener_->openCard());
    placeOverlays();
    map_->refresh(clock_.now());
}

void MainWindow::showStrip() {
    std::vector<StatusTile> tiles = statusTiles(model(), clock_.now());
    if (fleet_.several()) {
        const QString whose = fleet_.callSign(fleet_.chosen()).toUpper();
        tiles.front().label = tr("%1 · %2").arg(whose, tiles.front().label);
    }
    if (publishing_) tiles.back().detail += tr(" · published");
    strip_->show(tiles);
    strip_->setConnected(model().last().port != PortState::kClosed);
}

void MainWindow::showPublishing(const std::vector<PublishState>& states) {
    publishing_ = !states.empty();
    publish_card_->show(states);
    refresh();
}

void MainWindow::soundAlarms() {
    bool sounds = false;
    for (FleetRobot& robot : fleet_.robots()) {
        sounds = robot.alarm.sounds(robot.model.link(clock_.now()).state, clock_.now()) || sounds;
    }
    if (sounds) emit linkLost();
}

// Of the chosen robot; where that is well heard, of the first that is not.
void MainWindow::showLinkAdvice() {
    const auto advice = [this](const FleetRobot& robot) {
        return linkAdvice(robot.model.last(), robot.model.link(clock_.now()), clock_);
    };
    const FleetRobot* about = &fleet_.chosen();
    for (const FleetRobot& robot : fleet_.robots()) {
        if (!advice(*about).isEmpty()) break;
        about = &robot;
    }
    QString text = advice(*about);
    if (!text.isEmpty() && fleet_.several()) {
        text = tr("%1: %2").arg(fleet_.callSign(*about), text);
    }
    const bool lost = about->model.link(clock_.now()).state == LinkState::kLost;
    link_banner_->setText(text, lost ? BannerTone::kAlarm : BannerTone::kWarning);
}

void MainWindow::setTrailChoice(const TrailChoice& choice) {
    fleet_.setTrailChoice(choice);
    map_->showChosenTrails();
    refresh();
}

// For all robots alike: which trails an operator trusts is no question of the robot.
void MainWindow::makePrimary(const std::string& trail) {
    model().choosePrimary(trail);
    chosenAnew();
}

void MainWindow::showTrail(const std::string& trail, bool shown) {
    model().showTrail(trail, shown);
    chosenAnew();
}

void MainWindow::chosenAnew() {
    fleet_.setTrailChoice(TrailChoice(model().choice()));
    map_->showChosenTrails();
    refresh();
    emit trailChoiceChanged(model().choice());
}

// Before anything is driven there is no robot to lose: it will start on the floor that is shown.
void MainWindow::showFloor(std::size_t floor) {
    if (model().trails().empty()) desk_->site().moveRobot(floor);
    map_->setFloor(floor);
    refresh();
    map_->fit();
}

void MainWindow::moveRobotTo(std::size_t floor) {
    model().setFloor(floor);
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
    const auto needs = [floor](const FleetRobot& robot) {
        const LiveModel& of_robot = robot.model;
        const bool driving =
            of_robot.last().port != PortState::kClosed || !of_robot.trails().empty();
        return driving && floor <= of_robot.highestFloor();
    };
    if (std::ranges::any_of(fleet_.robots(), needs)) {
        return showRefusal(
            tr("%1 stays: in this mission a robot has been on it, or on one above it.").arg(name));
    }
    desk_->site().removeFloor(floor);
    showNote(tr("%1 is removed. Ctrl+Z brings it back.").arg(name), BannerTone::kNews);
}

}  // namespace hedr
