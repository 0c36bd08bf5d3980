#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "ui/connect_request.h"

namespace hedr {

// What the program remembers from one start to the next. One table in the .cpp serves load and
// save.
struct StoredSettings {
    QString theme = "day";
    QByteArray window_geometry{};
    QString primary_trail{};      // empty: never chosen
    QStringList shown_trails{};   // by the operator, though hidden at first
    QStringList hidden_trails{};  // by the operator
    QStringList recent_plans{};   // files, the newest first
    ConnectRequest connection{};  // of last time
    friend bool operator==(const StoredSettings&, const StoredSettings&) = default;
};

StoredSettings loadSettings();
void saveSettings(const StoredSettings& settings);

void rememberConnection(const ConnectRequest& request);

// Puts a plan that was opened in front of the recent ones, at most eight; gives them all.
QStringList rememberPlan(const QString& file);

}  // namespace hedr
