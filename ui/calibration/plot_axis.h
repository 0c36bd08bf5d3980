#pragma once

#include <QString>
#include <cmath>
#include <limits>
#include <vector>

namespace hedr {

// The smallest and the largest of some numbers.
struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    bool empty() const { return low > high; }
    void add(double value) {
        if (value < low) low = value;
        if (value > high) high = value;
    }
};

// One axis of a plot: numbers in the unit that is read, and where they are on the screen. It ends
// at ticks, so that it stays where it is while samples come in.
struct PlotAxis {
    double low = 0.0;
    double high = 1.0;
    double step = 0.5;  // between ticks; of a logarithmic axis in decades
    bool logarithmic = false;
    double from_px = 0.0;
    double to_px = 1.0;

    // NaN for what a logarithmic axis cannot show.
    double pixelOf(double value) const {
        const double share = logarithmic ? std::log(value / low) / std::log(high / low)
                                         : (value - low) / (high - low);
        const double pixel = from_px + share * (to_px - from_px);
        return std::isfinite(pixel) ? pixel : std::numeric_limits<double>::quiet_NaN();
    }
    std::vector<double> ticks() const;
    std::vector<double> minorTicks() const;  // 2 to 9 times a decade, or the decades between
    QString label(double tick) const;        // signed where both signs are there
};

// Ticks are at least `least_tick_px` apart. Nothing to show: 0 to 1.
PlotAxis plotAxis(Extent extent, bool logarithmic, double length_px, double least_tick_px);

// Widens the axis that shows less of the world per pixel, about its middle. Both have their pixels.
void giveSameScale(PlotAxis& x, PlotAxis& y);

}  // namespace hedr
