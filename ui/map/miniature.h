#pragma once

#include <QImage>
#include <QSize>

#include "ui/map/base_image.h"

namespace hedr {

// All of a scene, as small as that. Pure: may run on any thread.
QImage miniatureOf(const MapScene& scene, const QSize& size, double device_ratio);

}  // namespace hedr
