#pragma once

#include <QIcon>
#include <QPixmap>
#include <QString>

namespace hedr {

// A shipped line drawing (assets/icons/NAME.svg) in one colour.
QPixmap iconPixmap(const QString& name, const QColor& colour, int size_px, double device_ratio);

}  // namespace hedr
