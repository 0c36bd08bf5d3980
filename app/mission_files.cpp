#include "app/mission_files.h"

#include <QDateTime>
#include <QDir>
#include <QStandardPaths>

namespace hedr {

std::filesystem::path missionsFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return (data + "/missions").toStdString();
}

std::filesystem::path newMissionFile(RobotId robot) {
    const QDir folder(QString::fromStdString(missionsFolder().string()));
    (void)folder.mkpath(".");
    QString moment = QDateTime::currentDateTime().toString("yyyy-MM-dd'T'HH-mm-ss");
    // The files of robots that are connected together come a moment later.
    if (robot != kFirstRobot) moment.append(QStringLiteral("-robot%1").arg(robot));
    QString name = moment + ".hedr";
    // A clock that was set back, or a second window, must not continue another mission.
    for (int i = 2; folder.exists(name); ++i) name = moment + '-' + QString::number(i) + ".hedr";
    return folder.filePath(name).toStdString();
}

}  // namespace hedr
