#include "core/calibration/whiteness.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/distributions.h"

namespace hedr {

namespace {

constexpr std::size_t kFewestResiduals = 10;
constexpr std::size_t kResidualsPerLag = 4;
constexpr std::size_t kMostLags = 5;

double laggedProduct(std::span<const double> residuals, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < residuals.size(); ++i) sum += residuals[i] * residuals[i - lag];
    return sum;
}

}  // namespace

Whiteness whitenessOf(std::span<const double> residuals) {
    Whiteness result;
    const double power = laggedProduct(residuals, 0);
    if (residuals.size() < kFewestResiduals || !(power > 0.0)) return result;
    const double n = static_cast<double>(residuals.size());
    const std::size_t lags = std::min(kMostLags, residuals.size() / kResidualsPerLag);
    result.band = normalQuantile(0.975) / std::sqrt(n);
    for (std::size_t lag = 1; lag <= lags; ++lag) {
        const double correlation = laggedProduct(residuals, lag) / power;
        result.autocorrelation.push_back(correlation);
        result.statistic +=
            n * (n + 2.0) * correlation * correlation / (n - static_cast<double>(lag));
    }
    result.p_value = chiSquaredTail(result.statistic, static_cast<double>(lags));
    return result;
}

EvidencePlot autocorrelationPlot(const Whiteness& whiteness, double spacing_s) {
    EvidenceSeries band{"White noise, 95 %", EvidenceSeries::Shape::kBand};
    EvidenceSeries found{"Autocorrelation", EvidenceSeries::Shape::kSquares};
    for (const double correlation : whiteness.autocorrelation) {
        found.x.push_back(static_cast<double>(found.x.size() + 1) * spacing_s);
        found.y.push_back(correlation);
    }
    if (!found.x.empty()) {
        band.x = {0.0, found.x.back()};
        band.y = {-whiteness.band, -whiteness.band};
        band.y_high = {whiteness.band, whiteness.band};
    }
    return {"Rest that the curve leaves",
            {"Distance in time", "s"},
            {"Autocorrelation"},
            false,
            {std::move(band), std::move(found)}};
}

}  // namespace hedr
