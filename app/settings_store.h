#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <vector>

#include "ui/connect_request.h"
#include "ui/fleet.h"

namespace hedr {

// What the program remembers from one start to the next. One table in the .cpp serves load and
// save.
struct StoredSettings {
    QString theme = "day";
    QByteArray window_geometry{};
    QString primary_trail{};          // empty: never chosen
    QStringList shown_trails{};       // by the operator, though hidden at first
    QStringList hidden_trails{};      // by the operator
    QStringList recent_plans{};       // files, the newest first
    ConnectRequest connection{};      // of last time
    QStringList declined_missions{};  // were interrupted, and are not to be offered again
    friend bool operator==(const StoredSettings&, const StoredSettings&) = default;
};

StoredSettings loadSettings();
void saveSettings(const StoredSettings& settings);

void rememberConnection(const ConnectRequest& request);
void rememberDeclined(const QString& mission);  // while its file is there

// A mission that is being recorded, of which robot of its window, and how that was reached.
struct OpenMission {
    QString file;
    RobotId robot = kFirstRobot;
    ConnectRequest request{};
    friend bool operator==(const OpenMission&, const OpenMission&) = default;
};

// Each is kept for itself, so that two windows do not take each other's away.
void rememberOpenMission(const OpenMission& mission);
void forgetOpenMission(const QString& file);
std::vector<OpenMission> openMissions();  // ordered by their files

// Puts a plan that was opened in front of the recent ones, at most eight; gives them all.
QStringList rememberPlan(const QString& file);

}  // namespace hedr
