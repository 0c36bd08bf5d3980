#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/mission/mission.h"
#include "radio/live_batch.h"
#include "radio/serial_source.h"
#include "ui/connect_request.h"
#include "ui/plan_file_wish.h"

namespace hedr {

class LiveLink;
class MainWindow;

// Joins the window, the radio thread and the plan loader: what the operator asks goes down, what
// the radio hears comes up.
class Session : public QObject {
    Q_OBJECT

  public:
    struct Setup {
        std::optional<Vehicle> vehicle{};  // none: as the robot says
        std::filesystem::path mission{};   // empty: a new one for each connection
    };

    Session(MainWindow& window, Setup setup, QObject* parent = nullptr);
    ~Session() override;

    void connectTo(const SerialAddress& address, const std::optional<Vehicle>& vehicle);
    void openPlan(const PlanFileWish& wish);  // after those that are being opened
    // For the mission: whenever the site has changed, also without a connection; the next one
    // records it. A floor change is recorded with its time.
    void noteSite(const Site& site);
    void noteFloor(const std::string& name);

  private:
    void handleConnectRequest(const ConnectRequest& request);
    void disconnectLink();
    void startLink(const std::optional<Vehicle>& vehicle);
    void stopLink();
    void handleBatch(const LiveBatch& batch);
    static void tell(const std::optional<Error>& error, std::optional<ErrorCode>& told);
    void loadNextPlan();
    void cancelPlans();
    void handlePlanLoaded(int job, const PlanFileWish& wish, const Result<PlanImage>& plan);
    void showPlan(const PlanFileWish& wish, const PlanImage& plan);
    void report(const Error& error);

    MainWindow& window_;
    Setup setup_;
    QThread radio_thread_;
    LiveLink* link_ = nullptr;
    std::optional<MissionPlan> plan_{};
    std::optional<Site> site_{};
    std::string floor_{};  // on which the robot is; empty: nobody has said
    std::optional<ErrorCode> told_port_{};
    std::optional<ErrorCode> told_recorder_{};
    std::deque<PlanFileWish> plans_waiting_{};
    int plan_job_ = 0;
    std::shared_ptr<std::atomic<bool>> plan_canceled_{};  // of the plan that is being loaded
};

// Where missions go that were given no name: one file each, named after the moment it began.
std::filesystem::path newMissionFile();

}  // namespace hedr
