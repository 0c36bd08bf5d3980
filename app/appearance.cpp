#include "app/appearance.h"

#include "app/settings_store.h"
#include "ui/main_window.h"

namespace hedr {

namespace {

template <class Change>
void changeSettings(Change change) {
    StoredSettings settings = loadSettings();
    change(settings);
    saveSettings(settings);
}

TrailChoice choiceOf(const StoredSettings& settings) {
    TrailChoice choice{.primary = settings.primary_trail.toStdString()};
    for (const QString& name : settings.shown_trails) choice.shown[name.toStdString()] = true;
    for (const QString& name : settings.hidden_trails) choice.shown[name.toStdString()] = false;
    return choice;
}

void storeChoice(StoredSettings& settings, const TrailChoice& choice) {
    settings.primary_trail = QString::fromStdString(choice.primary);
    settings.shown_trails.clear();
    settings.hidden_trails.clear();
    for (const auto& [name, shown] : choice.shown) {
        (shown ? settings.shown_trails : settings.hidden_trails) << QString::fromStdString(name);
    }
}

}  // namespace

void rememberAppearance(MainWindow& window) {
    const StoredSettings stored = loadSettings();
    window.setTheme(stored.theme == "night" ? ThemeName::kNight : ThemeName::kDay);
    window.setTrailChoice(choiceOf(stored));
    if (!window.restoreGeometry(stored.window_geometry)) window.resize(1600, 1000);
    QObject::connect(&window, &MainWindow::themeChanged, [](ThemeName name) {
        changeSettings([&](StoredSettings& settings) {
            settings.theme = name == ThemeName::kNight ? "night" : "day";
        });
    });
    QObject::connect(&window, &MainWindow::trailChoiceChanged, [](const TrailChoice& choice) {
        changeSettings([&](StoredSettings& settings) { storeChoice(settings, choice); });
    });
}

void saveGeometry(const MainWindow& window) {
    changeSettings(
        [&](StoredSettings& settings) { settings.window_geometry = window.saveGeometry(); });
}

}  // namespace hedr
