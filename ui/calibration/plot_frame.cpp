#include "ui/calibration/plot_frame.h"

#include <algorithm>
#include <cmath>

#include "ui/fonts.h"

namespace hedr {
namespace {

constexpr double kName_px = 32.0;    // above the plot: the name of its y axis
constexpr double kBelow_px = 48.0;   // labels and name of the x axis
constexpr double kRight_px = 24.0;   // half a label
constexpr double kGutter_px = 48.0;  // left of it, and more where a label needs it
constexpr double kGridStep = 8.0;
constexpr double kLeastTickX_px = 72.0;
constexpr double kLeastTickY_px = 56.0;

Extent extentOf(const EvidencePlot& plot, bool of_y) {
    Extent extent;
    const EvidenceAxis& axis = of_y ? plot.y : plot.x;
    const auto add = [&](const std::vector<double>& values) {
        for (const double value : values) {
            if (canShow(axis, value)) extent.add(value);
        }
    };
    for (const EvidenceSeries& series : plot.series) {
        add(of_y ? series.y : series.x);
        if (of_y && series.shape == EvidenceSeries::Shape::kBand) add(series.y_high);
    }
    return extent;
}

// A logarithmic axis is read in its middle.
ReadUnit unitOf(const EvidenceAxis& axis, const Extent& extent) {
    if (extent.empty()) return readUnit(axis.unit, 1.0);
    const double size = axis.logarithmic ? std::sqrt(extent.low * extent.high)
                                         : std::max(std::abs(extent.low), std::abs(extent.high));
    return readUnit(axis.unit, size);
}

Extent scaled(const Extent& extent, const ReadUnit& unit) {
    if (extent.empty()) return extent;
    return {extent.low * unit.per_si, extent.high * unit.per_si};
}

double widestLabel(const PlotAxis& axis) {
    double widest = 0.0;
    const QFont font = uiFont(kPlotLabel_px);
    for (const double tick : axis.ticks()) {
        widest = std::max(widest, figuresWidth(font, axis.label(tick)));
    }
    return widest;
}

// Whether neighbouring labels of an axis from left to right leave room between them.
bool labelsFit(const PlotAxis& axis) {
    const std::vector<double> ticks = axis.ticks();
    if (ticks.size() < 2) return true;
    constexpr double kBetween_px = 12.0;
    const double apart_px = std::abs(axis.pixelOf(ticks[1]) - axis.pixelOf(ticks[0]));
    return apart_px >= widestLabel(axis) + kBetween_px;
}

PlotAxis axisAlong(const Extent& extent, bool logarithmic, double from_px, double to_px) {
    for (double least_px = kLeastTickX_px;; least_px *= 1.5) {
        PlotAxis axis = plotAxis(extent, logarithmic, to_px - from_px, least_px);
        axis.from_px = from_px;
        axis.to_px = to_px;
        if (labelsFit(axis) || least_px > to_px - from_px) return axis;
    }
}

}  // namespace

bool canShow(const EvidenceAxis& axis, double value_si) {
    constexpr double kLargest = 1e15;
    return std::abs(value_si) <= kLargest && (!axis.logarithmic || value_si > 0.0);
}

bool showsAnything(const EvidencePlot& plot) {
    return std::ranges::any_of(plot.series, [&](const EvidenceSeries& series) {
        const std::size_t count = std::min(series.x.size(), series.y.size());
        for (std::size_t i = 0; i < count; ++i) {
            if (canShow(plot.x, series.x[i]) && canShow(plot.y, series.y[i])) return true;
        }
        return false;
    });
}

PlotFrame plotFrame(const EvidencePlot& plot, const QSizeF& size) {
    const Extent x = extentOf(plot, false);
    const Extent y = extentOf(plot, true);
    PlotFrame frame{.x_unit = unitOf(plot.x, x), .y_unit = unitOf(plot.y, y)};
    // Lengths compare only in one unit.
    if (plot.same_scale && frame.x_unit.per_si > frame.y_unit.per_si) frame.x_unit = frame.y_unit;
    if (plot.same_scale) frame.y_unit = frame.x_unit;
    const double bottom = size.height() - kBelow_px;
    frame.y =
        plotAxis(scaled(y, frame.y_unit), plot.y.logarithmic, bottom - kName_px, kLeastTickY_px);
    frame.y.from_px = bottom;
    frame.y.to_px = kName_px;
    const double needed_px = std::max(kGutter_px, widestLabel(frame.y) + 12.0);
    const double left = std::ceil(needed_px / kGridStep) * kGridStep;
    frame.x =
        axisAlong(scaled(x, frame.x_unit), plot.x.logarithmic, left, size.width() - kRight_px);
    if (plot.same_scale) giveSameScale(frame.x, frame.y);
    frame.area = {QPointF(left, kName_px), QPointF(size.width() - kRight_px, bottom)};
    return frame;
}

}  // namespace hedr
