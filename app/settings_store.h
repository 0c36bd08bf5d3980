#pragma once

#include <QByteArray>
#include <QString>

namespace hedr {

// What the program remembers from one start to the next. One table in the .cpp serves load and
// save.
struct StoredSettings {
    QString theme = "day";
    QByteArray window_geometry{};
    friend bool operator==(const StoredSettings&, const StoredSettings&) = default;
};

StoredSettings loadSettings();
void saveSettings(const StoredSettings& settings);

}  // namespace hedr
