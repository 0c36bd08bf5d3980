#pragma once

#include <QFileDialog>

#include "ui/theme.h"

namespace hedr {

// Qt's own dialog for files in the look of the program: the desktop's has no room for what we
// show, and Qt's buttons are made for a light desktop and for more than choosing a file.
void dress(QFileDialog& dialog, const Theme& theme);

}  // namespace hedr
