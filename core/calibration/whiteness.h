#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/evidence.h"

namespace hedr {

// Whether residuals are white noise, as far as their autocorrelation tells.
struct Whiteness {
    std::vector<double> autocorrelation{};  // at lags 1, 2, ...
    double band = 0.0;       // 95 % of the autocorrelations of white noise are within ± that
    double statistic = 0.0;  // Ljung-Box, chi squared with as many degrees of freedom as lags
    double p_value = 1.0;    // of white noise that looks less white

    // One set of white residuals in a hundred is not taken for white.
    bool isWhite() const { return p_value >= 0.01; }
};

// G. M. Ljung, G. E. P. Box, "On a measure of lack of fit in time series models", Biometrika 65(2),
// 1978. Residuals at even distances, about zero. Fewer than ten, or all equal: nothing speaks
// against white noise.
Whiteness whitenessOf(std::span<const double> residuals);

// `spacing_s`: of the residuals.
EvidencePlot autocorrelationPlot(const Whiteness& whiteness, double spacing_s);

}  // namespace hedr
