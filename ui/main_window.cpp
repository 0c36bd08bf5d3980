#include "ui/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "radio/source/serial_ports.h"
#include "ui/fonts.h"
#include "ui/link/link_card.h"
#include "ui/link/robot_card.h"
#include "ui/map/map_view.h"
#include "ui/panels/banner.h"
#include "ui/panels/choice_note.h"
#include "ui/panels/connect_card.h"
#include "ui/panels/hint.h"
#include "ui/panels/legend.h"
#include "ui/panels/plan_progress_card.h"
#include "ui/panels/rail.h"
#include "ui/panels/status_strip.h"
#include "ui/panels/status_tiles.h"
#include "ui/site/plan_opener.h"
#include "ui/site/site_desk.h"
#include "ui/site/site_saver.h"

namespace hedr {
namespace {

constexpr int kRefresh_ms = 100;  // values for reading: faster would only flicker
constexpr double kZoomStep = 1.25;
constexpr double kPanStep_px = 80.0;

QStringList localFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) files << url.toLocalFile();
    }
    return files;
}

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

MainWindow::MainWindow(Clock clock, QWidget* parent)
    : QWidget(parent),
      clock_(std::move(clock)),
      theme_(dayTheme()),
      strip_(new StatusStrip(this)),
      map_(new MapView(model_, this)),
      rail_(new Rail(map_)),
      desk_(new SiteDesk(*map_, this)),
      opener_(new PlanOpener(map_, this)),
      saver_(new SiteSaver(desk_->site(), this)),
      legend_(new Legend(map_)),
      connect_card_(new ConnectCard(map_)),
      link_card_(new LinkCard(map_)),
      robot_card_(new RobotCard(map_)),
      link_banner_(new Banner(map_)),
      error_banner_(new Banner(map_)),
      note_banner_(new Banner(map_)),
      plan_progress_(new PlanProgressCard(tr("Loading the plan"), map_)),
      copy_progress_(new PlanProgressCard(tr("Saving the copy"), map_)),
      floor_note_(new ChoiceNote(
          {tr("Robot is here"), tr("It has changed floors: its trail goes on here (Enter)")},
          {tr("Back to it"), tr("Show the floor that the robot is on (R)")}, map_)),
      resume_note_(
          new ChoiceNote({tr("Go on"), tr("Connect again, and record into the same mission")},
                         {tr("Leave it"), tr("It stays as it is")}, map_)),
      hint_(new Hint(map_)) {
    setWindowTitle(tr("HEDR operator control unit"));
    setFont(uiFont(15));
    setMinimumSize(1024, 640);
    setAcceptDrops(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(strip_);
    column->addWidget(desk_->header());
    column->addWidget(map_, 1);
    error_banner_->setAcknowledgeable(true);
    note_banner_->setAcknowledgeable(true);
    note_timer_.setSingleShot(true);
    rail_->setFollowing(true);
    connect_card_->setPorts(listSerialPorts());
    createActions();
    connectPanels();
    connectSite();
    setTheme(theme_.name);
    refresh();
    refresh_timer_.start(kRefresh_ms);
    map_->setFocus();
}

MainWindow::~MainWindow() = default;

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

void MainWindow::connectPanels() {
    connect(strip_, &StatusStrip::connectionToggled, this, &MainWindow::toggleConnection);
    connect(strip_, &StatusStrip::tileClicked, this, [this] { toggleCard(link_card_); });
    connect(link_card_, &LinkCard::closeWished, this, [this] { toggleCard(link_card_); });
    connect(robot_card_, &RobotCard::closeWished, this, [this] { toggleCard(robot_card_); });
    connect(robot_card_, &RobotCard::asked, this, &MainWindow::ask);
    connect(robot_card_, &RobotCard::cancelWished, this, &MainWindow::cancelRequests);
    connect(robot_card_, &RobotCard::poseWished, this, [this] {
        if (const auto pose = model_.pose())
            ask(RobotCommand{.kind = CommandKind::kResetPose, .pose = *pose});
    });
    connect(resume_note_, &ChoiceNote::firstChosen, this, &MainWindow::resumeWished);
    connect(resume_note_, &ChoiceNote::secondChosen, this, &MainWindow::resumeDeclined);
    connect(rail_, &Rail::triggered, this, &MainWindow::trigger);
    connect(map_, &MapView::followingChanged, rail_, &Rail::setFollowing);
    connect(legend_, &Legend::showWished, this, &MainWindow::showTrail);
    connect(legend_, &Legend::primaryWished, this, &MainWindow::makePrimary);
    connect(legend_, &Legend::resized, this, &MainWindow::placeOverlays);
    connect(hint_, &QAbstractButton::clicked, opener_, &PlanOpener::ask);
    connect(plan_progress_, &PlanProgressCard::canceled, this, &MainWindow::planLoadCanceled);
    connect(copy_progress_, &PlanProgressCard::canceled, this, &MainWindow::copyCanceled);
    connect(error_banner_, &Banner::acknowledged, this, &MainWindow::placeOverlays);
    connect(note_banner_, &Banner::acknowledged, this, &MainWindow::placeOverlays);
    connect(&note_timer_, &QTimer::timeout, this, [this] { showNote({}, BannerTone::kNews); });
    connect(connect_card_, &ConnectCard::portsWanted, this,
            [this] { connect_card_->setPorts(listSerialPorts()); });
    connect(connect_card_, &ConnectCard::connectRequested, this,
            [this](const ConnectRequest& request) {
                connect_card_->hide();
                placeOverlays();
                emit connectRequested(request);
            });
    connect(&refresh_timer_, &QTimer::timeout, this, &MainWindow::refresh);
}

void MainWindow::connectSite() {
    connect(desk_, &SiteDesk::pageChanged, this, &MainWindow::showDesk);
    connect(desk_, &SiteDesk::removeFloorWished, this, &MainWindow::removeFloor);
    connect(desk_, &SiteDesk::openWished, opener_, &PlanOpener::ask);
    connect(desk_, &SiteDesk::openSiteWished, opener_, &PlanOpener::askForSite);
    connect(desk_, &SiteDesk::saveSiteWished, saver_, &SiteSaver::askForSite);
    connect(desk_, &SiteDesk::copyWished, saver_, &SiteSaver::askForCopy);
    connect(desk_, &SiteDesk::refused, this, &MainWindow::showRefusal);
    connect(saver_, &SiteSaver::copyChosen, this, &MainWindow::copyChosen);
    connect(saver_, &SiteSaver::siteChosen, this, &MainWindow::siteFileChosen);
    connect(saver_, &SiteSaver::refused, this, &MainWindow::showRefusal);
    connect(&desk_->site(), &SiteModel::floorShown, this, &MainWindow::showFloor);
    connect(&desk_->site(), &SiteModel::robotMoved, this, &MainWindow::moveRobotTo);
    connect(&desk_->site(), &SiteModel::changed, this, [this] {
        showFloorNote();
        placeOverlays();
    });
    connect(floor_note_, &ChoiceNote::firstChosen, this, &MainWindow::robotIsHere);
    connect(floor_note_, &ChoiceNote::secondChosen, this, &MainWindow::goToRobot);
    connect(opener_, &PlanOpener::cardChanged, this, &MainWindow::showOpener);
    connect(opener_, &PlanOpener::chosen, this, &MainWindow::planFileChosen);
}

void MainWindow::trigger(ActionId action) {
    switch (action) {
        case ActionId::kConnect:
            return toggleConnection();
        case ActionId::kLink:
            return toggleCard(link_card_);
        case ActionId::kRobot:
            return toggleCard(robot_card_);
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
        case ActionId::kAlign:
            return desk_->alignTopmost();
        case ActionId::kLayers:
            return desk_->toggleLayers();
        case ActionId::kFloorUp:
            return desk_->changeFloor(1);
        case ActionId::kFloorDown:
            return desk_->changeFloor(-1);
        case ActionId::kRobotHere:
            return robotIsHere();
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
        case ActionId::kQuit:
            close();
    }
}

void MainWindow::toggleFollowing() {
    if (!desk_->open() && !desk_->site().showsRobotFloor()) return goToRobot();
    map_->setFollowing(!map_->following());
    rail_->setFollowing(map_->following());
}

void MainWindow::showNextTrail() {
    if (const LiveTrail* next = model_.nextPrimary()) makePrimary(next->name);
}

// The plan that is moved by hand goes along by a pixel; else one looks further that way.
void MainWindow::arrow(Vector<View> towards) {
    if (!desk_->nudge(towards)) map_->panBy(-kPanStep_px * towards);
}

bool MainWindow::setPlan(const PlanImage& plan, int page) {
    const bool added = desk_->addImage(plan, page);
    if (added) map_->fit();
    if (added && plan.placement_is_guess) {
        showNote(tr("%1 says no scale and no place: both are a guess until you align it (A).")
                     .arg(QString::fromStdString(plan.image_file.filename().string())),
                 BannerTone::kWarning);
    }
    refresh();
    return added;
}

void MainWindow::setRecentPlans(const QStringList& files) { opener_->setRecentFiles(files); }

void MainWindow::proposeConnection(const ConnectRequest& earlier) {
    connect_card_->propose(earlier);
}

void MainWindow::askForConnection() {
    if (!connect_card_->isVisibleTo(map_)) toggleConnection();
}

void MainWindow::fitMap() { map_->fit(); }

void MainWindow::setTheme(ThemeName name) {
    theme_ = themeOf(name);
    strip_->setTheme(theme_);
    map_->setTheme(theme_);
    for (Card* card : std::initializer_list<Card*>{
             rail_, legend_, connect_card_, link_card_, robot_card_, link_banner_, error_banner_,
             note_banner_, floor_note_, resume_note_, plan_progress_, copy_progress_}) {
        card->setTheme(theme_);
    }
    hint_->setTheme(theme_);
    desk_->setTheme(theme_);
    opener_->setTheme(theme_);
    saver_->setTheme(theme_);
    emit themeChanged(name);
}

void MainWindow::toggleConnection() {
    if (model_.last().port != PortState::kClosed) {
        emit disconnectRequested();
        return;
    }
    connect_card_->setPorts(listSerialPorts());
    toggleCard(connect_card_);
}

void MainWindow::resizeEvent(QResizeEvent*) { placeOverlays(); }

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    opener_->offer(localFiles(*event->mimeData()));
    event->acceptProposedAction();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    refresh_timer_.stop();
    event->accept();
}

}  // namespace hedr
