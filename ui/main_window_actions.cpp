#include <QAction>

#include "ui/link/link_card.h"
#include "ui/link/robot_card.h"
#include "ui/main_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/rail.h"
#include "ui/publish/publish_card.h"
#include "ui/site/plan_opener.h"
#include "ui/site/site_desk.h"
#include "ui/site/site_saver.h"

// What the keys and the rail do; how the window is made is in main_window.cpp.
namespace hedr {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kPanStep_px = 80.0;

Vector<View> directionOf(ActionId arrow) {
    switch (arrow) {
        case ActionId::kLeft:
            return {-1.0, 0.0};
        case ActionId::kRight:
            return {1.0, 0.0};
        case ActionId::kUp:
            return {0.0, -1.0};
        default:
            return {0.0, 1.0};
    }
}

}  // namespace

void MainWindow::createActions() {
    for (const ActionEntry& entry : actionTable()) {
        auto* action = new QAction(entry.text, this);
        action->setShortcut(entry.key);
        QWidget* where = this;
        if (entry.on_map_only) {
            action->setShortcutContext(Qt::WidgetShortcut);
            where = map_;
        }
        if (entry.id == ActionId::kRobotHere) robot_here_ = action;
        if (entry.id == ActionId::kZoomIn) action->setShortcuts({entry.key, Qt::Key_Equal});
        connect(action, &QAction::triggered, this, [this, id = entry.id] { trigger(id); });
        where->addAction(action);
    }
}

void MainWindow::trigger(ActionId action) {
    switch (action) {
        case ActionId::kConnect:
            return toggleConnection();
        case ActionId::kLink:
            return toggleCard(link_card_);
        case ActionId::kRobot:
            return toggleCard(robot_card_);
        case ActionId::kPublish:
            return toggleCard(publish_card_);
        case ActionId::kCalibrate:
            return calibrate();
        case ActionId::kAddRobot:
            return connectAnother();
        case ActionId::kNextRobot:
            return chooseNextRobot();
        case ActionId::kFollow:
            return toggleFollowing();
        case ActionId::kFit:
            return map_->fit();
        case ActionId::kPlan:
            return opener_->ask();
        case ActionId::kOpenSite:
            return opener_->askForSite();
        case ActionId::kSaveSite:
            return saver_->askForSite();
        case ActionId::kTheme:
            return setTheme(theme_.name == ThemeName::kDay ? ThemeName::kNight : ThemeName::kDay);
        case ActionId::kZoomIn:
            return map_->zoomBy(kZoomStep);
        case ActionId::kZoomOut:
            return map_->zoomBy(1.0 / kZoomStep);
        case ActionId::kNextTrail:
            return showNextTrail();
        case ActionId::kLeft:
        case ActionId::kRight:
        case ActionId::kUp:
        case ActionId::kDown:
            return arrow(directionOf(action));
        case ActionId::kRobotHere:
            return robotIsHere();
        case ActionId::kQuit:
            close();
            return;
        default:
            return triggerOnPlans(action);
    }
}

void MainWindow::triggerOnPlans(ActionId action) {
    switch (action) {
        case ActionId::kAlign:
            return desk_->alignTopmost();
        case ActionId::kLayers:
            return desk_->toggleLayers();
        case ActionId::kFloorUp:
            return desk_->changeFloor(1);
        case ActionId::kFloorDown:
            return desk_->changeFloor(-1);
        case ActionId::kStraighten:
            return desk_->straightenTopmost();
        case ActionId::kWalls:
            return desk_->drawWalls();
        case ActionId::kCorridors:
            return desk_->tellCorridors();
        case ActionId::kTie:
            return desk_->tieToGlobe();
        case ActionId::kUndo:
            return desk_->undo();
        case ActionId::kRedo:
            return desk_->redo();
        case ActionId::kCancel:
            return desk_->cancel();
        default:
            return;
    }
}

void MainWindow::toggleFollowing() {
    if (!desk_->open() && !desk_->site().showsRobotFloor()) return goToRobot();
    map_->setFollowing(!map_->following());
    rail_->setFollowing(map_->following());
}

void MainWindow::showNextTrail() {
    if (const LiveTrail* next = model().nextPrimary()) makePrimary(next->name);
}

// The plan that is moved by hand goes along by a pixel; else one looks further that way.
void MainWindow::arrow(Vector<View> towards) {
    if (!desk_->nudge(towards)) map_->panBy(-kPanStep_px * towards);
}

}  // namespace hedr
