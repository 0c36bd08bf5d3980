#pragma once

#include <QString>

#include "ui/theme.h"

namespace hedr {

// The look of the words on a calibration's cards: those of a form, and a few of its own roles.
QString calibrationSheet(const Theme& theme);

}  // namespace hedr
