#include "app/calibration_keeper.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLocale>
#include <QStandardPaths>
#include <algorithm>

#include "ui/calibration/verdict_text.h"

namespace hedr {

namespace {

// A name as a robot says it may hold anything.
QString fileNameOf(const std::string& robot) {
    QString name;
    for (const QChar c : QString::fromStdString(robot)) {
        name += c.isLetterOrNumber() || c == '-' || c == '_' ? c : QChar('_');
    }
    return name.isEmpty() ? QStringLiteral("robot") : name;
}

QString dayOf(const std::string& time_utc) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(time_utc), Qt::ISODate);
    return QLocale::c().toString(time.toLocalTime().date(), QStringLiteral("d MMM yyyy"));
}

std::string nowUtc() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

std::string thisUser() { return qEnvironmentVariable("USER").toStdString(); }

}  // namespace

std::filesystem::path ownVehicleFile(const std::string& robot) {
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                      "/vehicles");
    (void)folder.mkpath(".");
    return folder.filePath(fileNameOf(robot) + ".toml").toStdString();
}

std::vector<ProcedureEntry> lastCalibrations(const std::vector<HistoryEntry>& history) {
    std::vector<ProcedureEntry> last;
    for (const HistoryEntry& entry : history) {
        if (!entry.record) continue;
        const CalibrationRecord& record = *entry.record;
        ProcedureEntry done{
            .procedure = QString::fromStdString(record.procedure), .title = {}, .purpose = {}};
        const bool declined = record.verdict == Verdict::kAccepted && !record.taken_over;
        done.last = dayOf(record.time_utc) + ", " +
                    (declined ? declinedWord() : verdictWord(record.verdict));
        if (!record.surface.empty()) done.last += ", " + QString::fromStdString(record.surface);
        done.verdict = record.verdict;
        last.push_back(done);
    }
    std::ranges::reverse(last);  // whoever looks one up wants the latest
    return last;
}

Result<KeptCalibration> keepOutcome(const std::filesystem::path& vehicle_file,
                                    const CalibrationOutcome& outcome) {
    const QString version =
        QCoreApplication::applicationName() + ' ' + QCoreApplication::applicationVersion();
    return keepInHistory(vehicle_file, outcome.calibration, outcome.input,
                         {.time_utc = nowUtc(),
                          .who = thisUser(),
                          .surface = outcome.surface.toStdString(),
                          .program_version = version.toStdString(),
                          .declined = outcome.declined});
}

Result<void> restoreCalibration(const std::filesystem::path& vehicle_file,
                                const HistoryEntry& entry, RestoreTo to) {
    return restoreVehicle(vehicle_file, entry, to, nowUtc(), thisUser());
}

}  // namespace hedr
