#pragma once

#include <QLabel>
#include <QStyle>

#include "ui/panels/status_tiles.h"

namespace hedr {

// Colours the words of a label that has the form sheet.
inline void setTone(QLabel& label, Tone tone) {
    const QString name = tone == Tone::kGood      ? QStringLiteral("good")
                         : tone == Tone::kWarning ? QStringLiteral("warning")
                         : tone == Tone::kAlarm   ? QStringLiteral("alarm")
                                                  : QString();
    if (label.property("tone").toString() == name) return;
    label.setProperty("tone", name);
    label.style()->unpolish(&label);
    label.style()->polish(&label);
}

}  // namespace hedr
