#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/site/plan.h"
#include "core/site/plan_copy.h"
#include "radio/live_batch.h"
#include "radio/publish/pose_publisher.h"
#include "radio/source/serial_ports.h"
#include "ui/actions.h"
#include "ui/clock.h"
#include "ui/connect_request.h"
#include "ui/fleet.h"
#include "ui/plan_file_wish.h"
#include "ui/theme.h"

namespace hedr {

class Banner;
class CalibrationDesk;
class HistoryPage;
struct HistoryView;
enum class RestoreTo : unsigned char;
struct CalibrationOutcome;
struct CalibrationPast;
class EndsPage;
class Card;
class ChoiceNote;
enum class BannerTone;
class ConnectCard;
class Hint;
class Legend;
class LinkCard;
class MapView;
class PlanOpener;
class PlanProgressCard;
class PublishCard;
class Rail;
class RobotCard;
class RobotsCard;
class SiteDesk;
class SiteSaver;
class StatusStrip;

// The operator's window: a strip of values above, a rail of actions on the left, the map in all the
// rest. It is told what happened and says what the operator wants; it opens no port and no file.
class MainWindow : public QWidget {
    Q_OBJECT

  public:
    explicit MainWindow(Clock clock = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    void applyBatch(const LiveBatch& batch, RobotId id = kFirstRobot);
    RobotId addRobot();  // it is the chosen one from now on
    void chooseRobot(RobotId robot);
    void setCallSign(RobotId robot, const QString& call_sign);  // empty: as it calls itself
    RobotId chosenRobot() const { return fleet_.chosen().id; }
    const Fleet& fleet() const { return fleet_; }
    bool setPlan(const PlanImage& plan, int page = 1);  // false: it was there
    void fitMap();
    SiteDesk& desk() { return *desk_; }
    void setRecentPlans(const QStringList& files);  // the newest first
    void askForConnection();
    void proposeConnection(const ConnectRequest& earlier);  // of last time
    void showPlanProgress(std::optional<double> progress);  // 0..1; none: done
    void showCopyProgress(std::optional<double> progress);  // the same, of what is written
    void showError(const Error& error);                     // until the operator acknowledges it
    void showSaved(const std::vector<std::filesystem::path>& files);  // for a while
    void showRefusal(const QString& why);                             // for a while
    // Whether the mission that the text names shall go on; empty: that is no question any more.
    void offerResuming(const QString& text);
    void showPublishing(const std::vector<PublishState>& states);
    // Which procedure.
    void chooseCalibration(const CalibrationPast& past);
    // Of the robot whose history was wished for; again after each wish of the operator's.
    void showHistory(const HistoryView& view);
    bool showsHistory() const;
    void showNews(const QString& text);     // for a while
    void showTrouble(const QString& text);  // until the operator acknowledges it
    void setTheme(ThemeName name);
    void setTrailChoice(const TrailChoice& choice);
    // Forgets its trails and home, for a new mission.
    void clearMission(RobotId id = kFirstRobot);

  signals:
    void connectRequested(const hedr::ConnectRequest& request, hedr::RobotId robot);
    void disconnectRequested(hedr::RobotId robot);
    void robotRemoved(hedr::RobotId robot);
    void resumeWished();
    void resumeDeclined();
    // The ticket is another one for each request.
    void requestWished(quint64 ticket, const hedr::Request& request, hedr::RobotId robot);
    void requestCanceled(quint64 ticket, hedr::RobotId robot);
    void publishWished(const std::vector<hedr::PublishTarget>& targets);
    void planFileChosen(const hedr::PlanFileWish& wish);
    void planLoadCanceled();
    void copyChosen(const hedr::PlanCopy& copy);
    void copyCanceled();
    void siteFileChosen(const QString& file);  // to be written
    void themeChanged(hedr::ThemeName name);
    void linkLost();  // worth a tone
    void trailChoiceChanged(const hedr::TrailChoice& choice);
    void calibrationWished(hedr::RobotId robot);  // its history is to be shown
    void historyWished(hedr::RobotId robot);
    void restoreWished(const QString& entry, hedr::RestoreTo to, hedr::RobotId robot);
    void exportWished(const QString& entry, const QString& folder, hedr::RobotId robot);
    void samplesWished(bool wished, hedr::RobotId robot);
    void calibrationConcluded(const hedr::CalibrationOutcome& outcome, hedr::RobotId robot);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    void createActions();
    void connectPanels();
    void connectSite();
    void placeOverlays();
    void refresh();  // whatever changes with time alone
    void refreshMapOnceAFrame();
    void refreshMap();
    void showStrip();
    void showLinkAdvice();
    void soundAlarms();
    LiveModel& model() { return fleet_.chosen().model; }
    void chooseNextRobot();
    void connectAnother();
    void removeRobot(RobotId robot);
    std::vector<SerialPortEntry> freePorts() const;
    void trigger(ActionId action);
    void triggerOnPlans(ActionId action);
    void toggleFollowing();
    void showNextTrail();
    void arrow(Vector<View> towards);
    void toggleConnection();
    std::array<Card*, 4> sideCards() const;
    void toggleCard(Card* card);
    void ask(const Request& request);
    void cancelRequests();
    void connectCalibration();
    void connectHistory();
    void askWhereToExport(const QString& entry);
    void calibrate();
    void showCalibration();
    QString samplesTrouble() const;  // why the robot to be calibrated is not heard
    QString requestRefusal() const;  // why the robot cannot be asked, empty where it can
    void makePrimary(const std::string& trail);
    void showTrail(const std::string& trail, bool shown);
    void chosenAnew();
    void showDesk();
    void showFloor(std::size_t floor);
    void moveRobotTo(std::size_t floor);
    void robotIsHere();  // on the floor that is shown
    void goToRobot();    // show its floor, and keep it in sight
    void removeFloor(std::size_t floor);
    void showFloorNote();  // where the floor that is shown is not the robot's
    void showOpener();
    void showWarning(const Error& warning, const FleetRobot& about);  // until it is acknowledged
    void showNote(const QString& text, BannerTone tone);

    Clock clock_;
    Theme theme_;
    Fleet fleet_;
    std::uint64_t last_ticket_ = 0;
    StatusStrip* strip_;
    MapView* map_;
    Rail* rail_;
    SiteDesk* desk_;
    PlanOpener* opener_;
    SiteSaver* saver_;
    RobotsCard* robots_card_;
    Legend* legend_;
    ConnectCard* connect_card_;
    LinkCard* link_card_;
    RobotCard* robot_card_;
    PublishCard* publish_card_;
    bool publishing_ = false;
    Banner* link_banner_;
    Banner* error_banner_;
    Banner* note_banner_;
    PlanProgressCard* plan_progress_;
    PlanProgressCard* copy_progress_;
    ChoiceNote* floor_note_;
    ChoiceNote* resume_note_;
    QAction* robot_here_ = nullptr;  // takes its key only while the note is shown
    Hint* hint_;
    CalibrationDesk* calibration_;
    HistoryPage* history_;
    EndsPage* ends_page_;
    RobotId calibrated_ = kFirstRobot;  // whom that is about
    QTimer refresh_timer_;
    QTimer note_timer_;
    QTimer map_timer_;  // until the next frame of the map
    ReceiveClock::time_point map_refreshed_{};
};

}  // namespace hedr
