#include "app/settings_store.h"

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

}  // namespace hedr
