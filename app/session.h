#pragma once

#include <QObject>
#include <QThread>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/plan_copier.h"
#include "app/site_keeper.h"
#include "core/mission/interrupted.h"
#include "core/mission/mission.h"
#include "radio/live_batch.h"
#include "radio/source/link_address.h"
#include "ui/connect_request.h"
#include "ui/plan_file_wish.h"

namespace hedr {

class LiveLink;
class MainWindow;

// Joins the window, the radio thread and the keeper of plans: what the operator asks goes down,
// what the radio hears comes up.
class Session : public QObject {
    Q_OBJECT

  public:
    struct Setup {
        std::optional<Vehicle> vehicle{};  // none: as the robot says
        std::filesystem::path mission{};   // empty: a new one for each connection
    };

    Session(MainWindow& window, Setup setup, QObject* parent = nullptr);
    ~Session() override;

    void connectTo(const LinkAddress& address, const std::optional<Vehicle>& vehicle);
    // Asks whether the mission that was interrupted last shall go on, where there is one.
    void offerResuming();
    void openPlan(const PlanFileWish& wish) { keeper_.open(wish); }

  private:
    void handleConnectRequest(const ConnectRequest& request);
    void resume();
    void declineResuming();
    void disconnectLink();
    void startLink(const std::optional<Vehicle>& vehicle);
    void stopLink();
    void handleBatch(const LiveBatch& batch);
    void rememberWhatWorked(const LiveBatch& batch);
    static void tell(const std::optional<Error>& error, std::optional<ErrorCode>& told);
    // For the mission: also without a connection, the next one records it.
    void noteSite(const Site& site);
    void noteRobotFloor();  // with its time
    void notePlan(const PlanImage& plan);
    void restoreSite(const Site& site);
    void rememberInList(const QString& file);
    void report(const Error& error);

    MainWindow& window_;
    Setup setup_;
    SiteKeeper keeper_;
    PlanCopier copier_;
    QThread radio_thread_;
    LiveLink* link_ = nullptr;
    std::optional<InterruptedMission> interrupted_{};  // that is offered
    std::filesystem::path resumed_{};                  // the next connection goes on with it
    std::optional<MissionPlan> plan_{};
    std::optional<Site> site_{};
    bool floor_said_ = false;                // on which the robot is
    std::optional<ConnectRequest> asked_{};  // of the operator, until it has worked
    std::optional<ErrorCode> told_port_{};
    std::optional<ErrorCode> told_recorder_{};
    std::optional<ErrorCode> told_key_{};
};

// Where missions go that were given no name: one file each, named after the moment it began.
std::filesystem::path newMissionFile();
std::filesystem::path missionsFolder();

}  // namespace hedr
