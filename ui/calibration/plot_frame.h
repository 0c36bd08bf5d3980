#pragma once

#include <QRectF>

#include "core/calibration/evidence.h"
#include "ui/calibration/evidence_units.h"
#include "ui/calibration/plot_axis.h"

namespace hedr {

inline constexpr int kPlotLabel_px = 13;

// Where a plot of some size has its axes, and in which units they are read.
struct PlotFrame {
    ReadUnit x_unit{};
    ReadUnit y_unit{};
    PlotAxis x{};
    PlotAxis y{};
    QRectF area{};  // between the axes
};

PlotFrame plotFrame(const EvidencePlot& plot, const QSizeF& size);

// Not the infinite, the absurd, and on a logarithmic axis what is not above 0.
bool canShow(const EvidenceAxis& axis, double value_si);
// Whether there is any point to be shown.
bool showsAnything(const EvidencePlot& plot);

}  // namespace hedr
