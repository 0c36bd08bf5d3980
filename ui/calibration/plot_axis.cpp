#include "ui/calibration/plot_axis.h"

#include <algorithm>

#include "ui/calibration/evidence_units.h"

namespace hedr {
namespace {

constexpr double kAlmost = 1e-9;  // of a step: what rounding leaves

// 1, 2 or 5 times a power of ten, at least that.
double roundStep(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= least * (1.0 - kAlmost)) return factor * decade;
    }
    return 10.0 * decade;
}

PlotAxis linearAxis(Extent extent, double most_ticks) {
    const double size = std::max(std::abs(extent.low), std::abs(extent.high));
    const double least_span = size > 0.0 ? 1e-6 * size : 1.0;
    if (extent.high - extent.low < least_span) {
        const double around = size > 0.0 ? 0.1 * size : 1.0;
        extent = {extent.low - around, extent.high + around};
    }
    PlotAxis axis;
    axis.step = roundStep((extent.high - extent.low) / most_ticks);
    axis.low = std::floor(extent.low / axis.step + kAlmost) * axis.step;
    axis.high = std::ceil(extent.high / axis.step - kAlmost) * axis.step;
    return axis;
}

PlotAxis decadeAxis(const Extent& extent, double most_ticks) {
    PlotAxis axis{.logarithmic = true};
    const double low = std::floor(std::log10(extent.low) + kAlmost);
    const double high = std::max(std::ceil(std::log10(extent.high) - kAlmost), low + 1.0);
    axis.step = std::max(1.0, std::ceil((high - low) / most_ticks));
    axis.low = std::pow(10.0, low);
    axis.high = std::pow(10.0, high);
    return axis;
}

QString powerOfTen(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("10⁻") : QStringLiteral("10");
    for (const QChar digit : QString::number(std::abs(exponent)))
        text += digits[digit.digitValue()];
    return text;
}

QString decadeLabel(double tick) {
    const int exponent = static_cast<int>(std::lround(std::log10(tick)));
    constexpr int kSmallestPlain = -4;
    constexpr int kLargestPlain = 4;
    if (exponent < kSmallestPlain || exponent > kLargestPlain) return powerOfTen(exponent);
    return plainNumber(tick, std::max(0, -exponent));
}

double unitsPerPixel(const PlotAxis& axis) {
    return (axis.high - axis.low) / std::abs(axis.to_px - axis.from_px);
}

void widen(PlotAxis& axis, double units_per_px) {
    const double by = 0.5 * (units_per_px / unitsPerPixel(axis) - 1.0) * (axis.high - axis.low);
    axis.low -= by;
    axis.high += by;
}

}  // namespace

std::vector<double> PlotAxis::ticks() const {
    const double first = logarithmic ? std::log10(low) : std::ceil(low / step - kAlmost) * step;
    const double last = logarithmic ? std::log10(high) : high;
    std::vector<double> ticks;
    for (int i = 0; first + i * step <= last + kAlmost * step; ++i) {
        const double tick = first + i * step;
        ticks.push_back(logarithmic ? std::pow(10.0, tick) : std::round(tick / step) * step);
    }
    return ticks;
}

std::vector<double> PlotAxis::minorTicks() const {
    std::vector<double> minor;
    if (!logarithmic) return minor;
    for (const double tick : ticks()) {
        for (int i = 2; i <= 9 && step == 1.0; ++i) minor.push_back(i * tick);
        for (int i = 1; i < step; ++i) minor.push_back(std::pow(10.0, i) * tick);
    }
    std::erase_if(minor, [this](double tick) { return tick > high; });
    return minor;
}

QString PlotAxis::label(double tick) const {
    if (logarithmic) return decadeLabel(tick);
    const QString number = plainNumber(tick, std::max(0, decimalsFor(step, 1)));
    return low < 0.0 && high > 0.0 && tick > 0.5 * step ? QLatin1Char('+') + number : number;
}

PlotAxis plotAxis(Extent extent, bool logarithmic, double length_px, double least_tick_px) {
    const double most_ticks = std::max(2.0, std::floor(length_px / least_tick_px));
    if (logarithmic) return decadeAxis(extent.empty() ? Extent{1.0, 10.0} : extent, most_ticks);
    return linearAxis(extent.empty() ? Extent{0.0, 1.0} : extent, most_ticks);
}

void giveSameScale(PlotAxis& x, PlotAxis& y) {
    x.step = y.step = std::max(x.step, y.step);
    const double units_per_px = std::max(unitsPerPixel(x), unitsPerPixel(y));
    widen(x, units_per_px);
    widen(y, units_per_px);
}

}  // namespace hedr
