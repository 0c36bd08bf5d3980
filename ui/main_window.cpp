#include "ui/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "radio/source/serial_ports.h"
#include "ui/calibration/calibration_desk.h"
#include "ui/calibration/ends_page.h"
#include "ui/calibration/history_page.h"
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
#include "ui/panels/robots_card.h"
#include "ui/panels/status_strip.h"
#include "ui/publish/publish_card.h"
#include "ui/site/plan_opener.h"
#include "ui/site/site_desk.h"
#include "ui/site/site_saver.h"

namespace hedr {
namespace {

constexpr int kRefresh_ms = 100;  // values for reading: faster would only flicker

QStringList localFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) files << url.toLocalFile();
    }
    return files;
}

}  // namespace

MainWindow::MainWindow(Clock clock, QWidget* parent)
    : QWidget(parent),
      clock_(std::move(clock)),
      theme_(dayTheme()),
      strip_(new StatusStrip(this)),
      map_(new MapView(fleet_, this)),
      rail_(new Rail(map_)),
      desk_(new SiteDesk(*map_, this)),
      opener_(new PlanOpener(map_, this)),
      saver_(new SiteSaver(desk_->site(), this)),
      robots_card_(new RobotsCard(map_)),
      legend_(new Legend(map_)),
      connect_card_(new ConnectCard(map_)),
      link_card_(new LinkCard(map_)),
      robot_card_(new RobotCard(map_)),
      publish_card_(new PublishCard(map_)),
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
      hint_(new Hint(map_)),
      calibration_(new CalibrationDesk(this)),
      history_(new HistoryPage(this)),
      ends_page_(new EndsPage(map_)) {
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
    map_timer_.setSingleShot(true);
    map_timer_.setTimerType(Qt::PreciseTimer);
    rail_->setFollowing(true);
    connect_card_->setPorts(listSerialPorts());
    createActions();
    connectPanels();
    connectSite();
    connectCalibration();
    connectHistory();
    setTheme(theme_.name);
    refresh();
    refresh_timer_.start(kRefresh_ms);
    map_->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::connectPanels() {
    connect(strip_, &StatusStrip::connectionToggled, this, &MainWindow::toggleConnection);
    connect(strip_, &StatusStrip::tileClicked, this, [this] { toggleCard(link_card_); });
    connect(link_card_, &LinkCard::closeWished, this, [this] { toggleCard(link_card_); });
    connect(robot_card_, &RobotCard::closeWished, this, [this] { toggleCard(robot_card_); });
    connect(publish_card_, &PublishCard::closeWished, this, [this] { toggleCard(publish_card_); });
    connect(publish_card_, &PublishCard::targetsWished, this, &MainWindow::publishWished);
    connect(robot_card_, &RobotCard::asked, this, &MainWindow::ask);
    connect(robot_card_, &RobotCard::cancelWished, this, &MainWindow::cancelRequests);
    connect(robot_card_, &RobotCard::poseWished, this, [this] {
        if (const auto pose = model().pose())
            ask(RobotCommand{.kind = CommandKind::kResetPose, .pose = *pose});
    });
    connect(resume_note_, &ChoiceNote::firstChosen, this, &MainWindow::resumeWished);
    connect(resume_note_, &ChoiceNote::secondChosen, this, &MainWindow::resumeDeclined);
    connect(rail_, &Rail::triggered, this, &MainWindow::trigger);
    connect(map_, &MapView::followingChanged, rail_, &Rail::setFollowing);
    connect(map_, &MapView::robotClicked, this, &MainWindow::chooseRobot);
    connect(robots_card_, &RobotsCard::robotChosen, this, &MainWindow::chooseRobot);
    connect(robots_card_, &RobotsCard::removeWished, this, &MainWindow::removeRobot);
    connect(robots_card_, &RobotsCard::addWished, this, &MainWindow::connectAnother);
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
            [this] { connect_card_->setPorts(freePorts()); });
    connect(connect_card_, &ConnectCard::connectRequested, this,
            [this](const ConnectRequest& request) {
                connect_card_->hide();
                setCallSign(fleet_.chosen().id, request.call_sign);
                emit connectRequested(request, fleet_.chosen().id);
            });
    connect(&refresh_timer_, &QTimer::timeout, this, &MainWindow::refresh);
    connect(&map_timer_, &QTimer::timeout, this, &MainWindow::refreshMap);
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

void MainWindow::fitMap() { map_->fit(); }

void MainWindow::setTheme(ThemeName name) {
    theme_ = themeOf(name);
    strip_->setTheme(theme_);
    map_->setTheme(theme_);
    for (Card* card :
         std::initializer_list<Card*>{rail_, robots_card_, connect_card_, link_card_, robot_card_,
                                      publish_card_, link_banner_, error_banner_, note_banner_,
                                      floor_note_, resume_note_, plan_progress_, copy_progress_}) {
        card->setTheme(theme_);
    }
    legend_->setTheme(inColourOf(fleet_.chosen().mark, theme_));
    hint_->setTheme(theme_);
    desk_->setTheme(theme_);
    opener_->setTheme(theme_);
    saver_->setTheme(theme_);
    calibration_->setTheme(theme_);
    history_->setTheme(theme_);
    emit themeChanged(name);
}

void MainWindow::resizeEvent(QResizeEvent*) {
    placeOverlays();
    calibration_->place();
    history_->setGeometry(rect());
}

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
