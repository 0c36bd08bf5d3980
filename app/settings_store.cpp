#include "app/settings_store.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace hedr {

namespace {

// Calls visit(key, value) for each setting: load and save cannot disagree.
template <class Settings, class Visit>
void forEachSetting(Settings& settings, Visit&& visit) {
    visit("theme", settings.theme);
    visit("window/geometry", settings.window_geometry);
    visit("trails/primary", settings.primary_trail);
    visit("trails/shown", settings.shown_trails);
    visit("trails/hidden", settings.hidden_trails);
    visit("plans/recent", settings.recent_plans);
    visit("missions/declined", settings.declined_missions);
}

// The same for what is known of a connection, below the group that is open.
template <class Request, class Visit>
void forEachPart(Request& request, Visit&& visit) {
    visit("port", request.port);
    visit("baud", request.baud);
    visit("identity", request.identity);
    visit("vehicle", request.vehicle_preset);
    visit("vehicle_file", request.vehicle_file);
    visit("call_sign", request.call_sign);
}

auto reader(const QSettings& store) {
    return [&store]<class T>(const char* key, T& value) {
        value = store.value(key, value).template value<T>();
    };
}

auto writer(QSettings& store) {
    return [&store](const char* key, const auto& value) { store.setValue(key, value); };
}

// A slash in a name would begin a group.
QString groupOf(const QString& mission) {
    return QStringLiteral("open/") + QString::fromLatin1(mission.toUtf8().toHex());
}

}  // namespace

StoredSettings loadSettings() {
    QSettings store;
    StoredSettings settings;
    forEachSetting(settings, reader(store));
    store.beginGroup("connection");
    forEachPart(settings.connection, reader(store));
    return settings;
}

void saveSettings(const StoredSettings& settings) {
    QSettings store;
    forEachSetting(settings, writer(store));
    store.beginGroup("connection");
    forEachPart(settings.connection, writer(store));
}

void rememberOpenMission(const OpenMission& mission) {
    QSettings store;
    store.beginGroup(groupOf(mission.file));
    store.setValue("robot", mission.robot);
    forEachPart(mission.request, writer(store));
}

void forgetOpenMission(const QString& file) { QSettings().remove(groupOf(file)); }

std::vector<OpenMission> openMissions() {
    QSettings store;
    store.beginGroup("open");
    std::vector<OpenMission> missions;
    for (const QString& name : store.childGroups()) {
        store.beginGroup(name);
        OpenMission mission{.file = QString::fromUtf8(QByteArray::fromHex(name.toLatin1()))};
        mission.robot = store.value("robot", kFirstRobot).toUInt();
        forEachPart(mission.request, reader(store));
        missions.push_back(std::move(mission));
        store.endGroup();
    }
    return missions;
}

void rememberConnection(const ConnectRequest& request) {
    StoredSettings settings = loadSettings();
    settings.connection = request;
    saveSettings(settings);
}

void rememberDeclined(const QString& mission) {
    StoredSettings settings = loadSettings();
    QStringList& declined = settings.declined_missions;
    declined.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    if (!declined.contains(mission)) declined.append(mission);
    saveSettings(settings);
}

QStringList rememberPlan(const QString& file) {
    constexpr qsizetype kMostPlans = 8;
    StoredSettings settings = loadSettings();
    QStringList& plans = settings.recent_plans;
    const QString path = QDir::cleanPath(QFileInfo(file).absoluteFilePath());
    plans.removeAll(path);
    plans.prepend(path);
    if (plans.size() > kMostPlans) plans.resize(kMostPlans);
    saveSettings(settings);
    return plans;
}

}  // namespace hedr
