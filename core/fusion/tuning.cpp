#include "core/fusion/tuning.h"

#include <array>
#include <cmath>
#include <limits>

namespace hedr {

namespace {

constexpr std::array kCoarse{0.1, 0.3, 0.5, 0.7, 0.9};
constexpr std::array kFine{-0.10, -0.05, 0.0, 0.05, 0.10};

std::vector<double> around(double best) {
    std::vector<double> values;
    for (const double step : kFine) {
        const double value = best + step;
        // In steps of 0.05, 0.9 and 0.1 may miss 1 by a rounding error.
        if (value > -1e-9 && value < 1.0 + 1e-9)
            values.push_back(std::round(value * 100.0) / 100.0);
    }
    return values;
}

}  // namespace

std::optional<Tuning> tuneGains(const GhGains& start,
                                const std::vector<double GhGains::*>& gains_to_tune,
                                const std::function<double(const GhGains&)>& error,
                                const std::function<bool(std::size_t, std::size_t)>& go_on) {
    Tuning tuning{.best = start, .sweeps = {}};
    const std::size_t trials = gains_to_tune.size() * (kCoarse.size() + kFine.size());
    std::size_t made = 0;
    const auto sweep = [&](double GhGains::*gain, const std::vector<double>& values) {
        TuningSweep result{.gain = gain, .trials = {}};
        tuning.error = std::numeric_limits<double>::infinity();
        for (const double value : values) {
            if (!go_on(made++, trials)) return false;
            GhGains gains = tuning.best;
            gains.*gain = value;
            const double judged = error(gains);
            result.trials.push_back({value, judged});
            if (!(judged < tuning.error)) continue;
            tuning.error = judged;
            result.chosen = value;
        }
        tuning.best.*gain = result.chosen;
        tuning.sweeps.push_back(result);
        return true;
    };
    for (const auto gain : gains_to_tune) {
        if (!sweep(gain, {kCoarse.begin(), kCoarse.end()})) return std::nullopt;
    }
    for (const auto gain : gains_to_tune) {
        if (!sweep(gain, around(tuning.best.*gain))) return std::nullopt;
    }
    return tuning;
}

}  // namespace hedr
