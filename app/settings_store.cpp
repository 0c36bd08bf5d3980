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
    visit("connection/port", settings.connection.port);
    visit("connection/baud", settings.connection.baud);
    visit("connection/identity", settings.connection.identity);
    visit("connection/vehicle", settings.connection.vehicle_preset);
    visit("connection/vehicle_file", settings.connection.vehicle_file);
    visit("connection/call_sign", settings.connection.call_sign);
}

}  // namespace

StoredSettings loadSettings() {
    const QSettings store;
    StoredSettings settings;
    forEachSetting(settings, [&store]<class T>(const char* key, T& value) {
        value = store.value(key, value).template value<T>();
    });
    return settings;
}

void saveSettings(const StoredSettings& settings) {
    QSettings store;
    forEachSetting(settings,
                   [&store](const char* key, const auto& value) { store.setValue(key, value); });
}

void rememberConnection(const ConnectRequest& request) {
    StoredSettings settings = loadSettings();
    settings.connection = request;
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
