#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/interrupted_robots.h"
#include "app/plan_copier.h"
#include "app/publishing.h"
#include "app/robot_link.h"
#include "app/robot_writer.h"
#include "app/site_keeper.h"
#include "core/calibration/calibration.h"
#include "core/mission/mission.h"
#include "radio/live_batch.h"
#include "radio/source/link_address.h"
#include "ui/background_job.h"
#include "ui/connect_request.h"
#include "ui/fleet.h"
#include "ui/plan_file_wish.h"

namespace hedr {

class MainWindow;
struct CalibrationOutcome;
struct KeptCalibration;
enum class RestoreTo : unsigned char;

// Joins the window, the robots' links and the keeper of plans: what the operator asks goes down,
// what the radio hears comes up.
class Session : public QObject {
    Q_OBJECT

  public:
    struct Setup {
        std::optional<Vehicle> vehicle{};      // none: as the robot says
        std::filesystem::path vehicle_file{};  // of it; empty: it has none
        // Of the first robot, those of the others beside it; empty: a new one for each connection.
        std::filesystem::path mission{};
        bool robots_last = true;  // false: they go with the program
    };

    Session(MainWindow& window, Setup setup, QObject* parent = nullptr);
    ~Session() override;

    void connectTo(const LinkAddress& address, const std::optional<Vehicle>& vehicle,
                   RobotId robot = kFirstRobot);
    void connectToAll(const QStringList& ports);  // one robot each
    void publishTo(const std::vector<PublishTarget>& targets);
    // Asks whether the missions that were interrupted shall go on, where there are any.
    void offerResuming();
    void openPlan(const PlanFileWish& wish) { keeper_.open(wish); }

  private:
    void joinWindow();
    void joinKeeper();
    void joinCalibration();
    void handleConnectRequest(const ConnectRequest& request, RobotId robot);
    void resume();
    bool goOn(const InterruptedRobot& interrupted);  // false: it cannot be reached
    void askToReach(const InterruptedRobot& interrupted);
    void declineResuming();
    // What is known of one robot's connection.
    struct Connection {
        std::optional<ConnectRequest> way{};      // by which it is reached again
        std::unique_ptr<OpenMissionNote> note{};  // while it is recorded; goes after the link
        std::unique_ptr<RobotLink> link{};
        std::filesystem::path vehicle_file{};     // empty: the program's own
        std::vector<Calibration> calibrations{};  // that its vehicle file has taken meanwhile
        std::unique_ptr<RobotWriter> writer{};    // of its parameters
        bool floor_said = false;                  // on which the robot is
        std::optional<ConnectRequest> asked{};    // of the operator, until it has worked
        std::optional<ErrorCode> told_port{};
        std::optional<ErrorCode> told_recorder{};
        std::optional<ErrorCode> told_key{};
    };

    RobotLink* linkOf(RobotId robot) const;  // nullptr: it was never connected
    RobotId unusedRobot();
    std::optional<ConnectRequest> wayTo(const LinkAddress& address) const;
    void noteOpenMission(const LiveBatch& batch, Connection& connection, RobotId robot);
    std::filesystem::path missionFileOf(RobotId robot);
    void startLink(const std::optional<Vehicle>& vehicle, RobotId robot);
    void setPace();  // of all links, as the window draws
    void handleBatch(const LiveBatch& batch, RobotId robot);
    void rememberWhatWorked(const LiveBatch& batch, Connection& connection);
    static void tell(const std::optional<Error>& error, std::optional<ErrorCode>& told);
    // For the mission: also without a connection, the next one records it.
    void publishPoses();
    std::filesystem::path vehicleFileOf(RobotId robot) const;
    void keepCalibration(const CalibrationOutcome& outcome, RobotId robot);
    void tellKept(const Result<KeptCalibration>& kept, const std::filesystem::path& file,
                  RobotId robot);
    void writeToRobot(const std::vector<ParameterSet>& wishes, RobotId robot);
    void showHistory(RobotId robot, const QString& news);
    void restore(const QString& entry, RestoreTo to, RobotId robot);
    void exportCalibration(const QString& entry, const QString& folder, RobotId robot);
    void dropWriter(Connection& connection);
    void proposeVehicle(const std::filesystem::path& file, RobotId robot);
    void noteSite(const Site& site);
    void noteRobotFloor();  // of the robot that is chosen, with its time
    void notePlan(const PlanImage& plan);
    void restoreSite(const Site& site);
    void rememberInList(const QString& file);
    void report(const Error& error);

    MainWindow& window_;
    Setup setup_;
    SiteKeeper keeper_;
    PlanCopier copier_;
    Publishing publishing_;
    QTimer publish_timer_;  // while there is someone to publish to
    std::map<RobotId, Connection> connections_;
    BackgroundJob keeping_{};                             // of a calibration
    BackgroundJob exporting_{};                           // the same
    std::optional<RobotId> sampled_{};                    // whose sensors a calibration listens to
    std::vector<InterruptedRobot> interrupted_{};         // that are offered
    std::vector<InterruptedRobot> passed_over_{};         // until another robot is heard
    std::map<RobotId, std::filesystem::path> resumed_{};  // the next connection goes on with it
    std::optional<MissionPlan> plan_{};
    std::optional<Site> site_{};
};

}  // namespace hedr
