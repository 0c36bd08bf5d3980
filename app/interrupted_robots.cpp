#include "app/interrupted_robots.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/mission_files.h"
#include "app/settings_store.h"
#include "ui/format.h"

namespace hedr {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("InterruptedRobots", text); }

QString nameOf(const InterruptedRobot& robot) {
    return QString::fromStdString(robot.mission.file.string());
}

bool sameConnection(const ConnectRequest& one, const ConnectRequest& other) {
    return one.identity.isEmpty() ? one.port == other.port : one.identity == other.identity;
}

// One robot can go on with one mission only: the others of its connection are older.
std::vector<InterruptedRobot> newestOfEach(std::vector<InterruptedRobot> robots) {
    const auto start = [](const InterruptedRobot& robot) { return robot.mission.info.start; };
    std::ranges::sort(robots, std::greater{}, start);
    std::vector<InterruptedRobot> newest;
    for (InterruptedRobot& robot : robots) {
        const bool older = std::ranges::any_of(newest, [&](const InterruptedRobot& other) {
            return sameConnection(robot.request, other.request);
        });
        older ? forgetOpenMission(nameOf(robot)) : newest.push_back(std::move(robot));
    }
    std::ranges::stable_sort(newest, {}, &InterruptedRobot::robot);
    return newest;
}

}  // namespace

OpenMissionNote::OpenMissionNote(std::string mission, RobotId robot, const ConnectRequest& request)
    : mission_(std::move(mission)), robot_(robot) {
    setRequest(request);
}

OpenMissionNote::~OpenMissionNote() { forgetOpenMission(QString::fromStdString(mission_)); }

void OpenMissionNote::setRequest(const ConnectRequest& request) {
    rememberOpenMission({QString::fromStdString(mission_), robot_, request});
}

std::vector<InterruptedRobot> findInterruptedRobots() {
    std::vector<InterruptedRobot> robots;
    for (const OpenMission& open : openMissions()) {
        const std::filesystem::path file = open.file.toStdString();
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored)) forgetOpenMission(open.file);
        if (auto mission = interruptedIn(file))
            robots.push_back({std::move(*mission), open.robot, open.request});
    }
    if (!robots.empty()) return newestOfEach(std::move(robots));
    const QStringList declined = loadSettings().declined_missions;
    if (auto newest = findInterrupted(missionsFolder())) robots.push_back({std::move(*newest)});
    std::erase_if(robots, [&](const auto& robot) { return declined.contains(nameOf(robot)); });
    return robots;
}

std::vector<InterruptedRobot> stillInterrupted(std::vector<InterruptedRobot> robots) {
    std::erase_if(robots,
                  [](const InterruptedRobot& robot) { return !interruptedIn(robot.mission.file); });
    return robots;
}

ConnectRequest located(ConnectRequest request, const std::vector<SerialPortEntry>& ports) {
    if (request.identity.isEmpty()) return request;
    const auto found = std::ranges::find(ports, request.identity, &SerialPortEntry::identity);
    request.port = found == ports.end() ? QString() : found->device;
    return request;
}

QString resumeQuestion(const std::vector<InterruptedRobot>& robots) {
    if (robots.empty()) return {};
    const auto start = std::ranges::min(robots, {}, [](const auto& robot) {
                           return robot.mission.info.start;
                       }).mission.info.start.time_since_epoch();
    const QDateTime began = QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<std::chrono::milliseconds>(start).count());
    const bool today = began.date() == QDate::currentDate();
    const QString when = began.toString(today ? "HH:mm" : "yyyy-MM-dd HH:mm");
    if (robots.size() > 1) {
        return tr("The missions of %1 robots were interrupted. The first began at %2. Go on with "
                  "all of them?")
            .arg(QString::number(robots.size()), when);
    }
    return tr("The mission of %1 was interrupted after %2. Go on with it?")
        .arg(when, formatDuration(robots.front().mission.info.duration_s));
}

void leave(const std::vector<InterruptedRobot>& robots) {
    for (const InterruptedRobot& robot : stillInterrupted(robots)) forgetOpenMission(nameOf(robot));
}

Result<void> decline(const std::vector<InterruptedRobot>& robots) {
    Result<void> outcome;
    for (const InterruptedRobot& robot : stillInterrupted(robots)) {
        forgetOpenMission(nameOf(robot));
        rememberDeclined(nameOf(robot));  // a damaged one cannot be closed
        if (const auto closed = closeInterrupted(robot.mission.file); !closed) outcome = closed;
    }
    return outcome;
}

}  // namespace hedr
