#pragma once

#include <QString>

#include "ui/theme.h"

namespace hedr {

// Standard widgets in the look of a theme.
QString primaryButtonSheet(const Theme& theme);  // the one thing to do now
QString buttonSheet(const Theme& theme);
QString flatButtonSheet(const Theme& theme);      // one of many, without a field of its own
QString flatMenuButtonSheet(const Theme& theme);  // such a one that opens a menu
QString segmentSheet(const Theme& theme);         // one of a row, of which one is chosen
QString quietFieldSheet(const Theme& theme);      // a title that can be typed over
QString sliderSheet(const Theme& theme);
QString menuSheet(const Theme& theme);
QString scrollSheet(const Theme& theme);       // a list on a card
QString pictureListSheet(const Theme& theme);  // pictures of which one is chosen
QString dialogSheet(const Theme& theme);       // a window of its own
QString formSheet(const Theme& theme);         // labels, fields and lists of a card

}  // namespace hedr
