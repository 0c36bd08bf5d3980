#include "ui/calibration/calibration_sheet.h"

#include "ui/fonts.h"
#include "ui/style_sheet.h"

namespace hedr {

QString calibrationSheet(const Theme& theme) {
    const QString own = QStringLiteral(R"(
QLabel[role="caption"] { font: 13px "@family"; color: @dim; }
QLabel[role="step"] { font: 600 16px "@family"; color: @ink; }
QLabel[role="detail"] { font: 14px "@family"; color: @dim; }
QLabel[role="words"] { font: 14px "@family"; color: @ink; }
QScrollArea { border: 2px solid transparent; border-radius: 8px; }
QScrollArea:focus { border-color: @accent; }
)");
    // First its own: the tones of the form go over them.
    return QString(own)
               .replace("@family", uiFont(16).family())
               .replace("@ink", theme.ink.name())
               .replace("@dim", theme.dim.name())
               .replace("@accent", theme.accent.name()) +
           formSheet(theme) + scrollSheet(theme);
}

}  // namespace hedr
