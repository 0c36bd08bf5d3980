#include "core/calibration/gyro/warmup_forecast.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace hedr {

namespace {

constexpr double kNextDrive_s = 600.0;
constexpr int kForecastBlocks = 60;
constexpr double kForecastStep = 1.03;
constexpr double kLongestForecast = 10.0;  // times what was seen

// Standard error of ln T after so long, but for the noise.
double timeErrorAfter(const WarmupFit& fit, double begin_s, double duration_s) {
    const double block_s = duration_s / kForecastBlocks;
    std::vector<WarmupBlock> blocks;
    blocks.reserve(kForecastBlocks);
    for (int i = 0; i < kForecastBlocks; ++i) {
        const double from_s = begin_s + i * block_s;
        blocks.push_back({from_s, from_s + block_s, 0.0, block_s});
    }
    const Eigen::MatrixXd jacobian = warmupJacobian(blocks, fit.curve, fit.room);
    const Eigen::MatrixXd information = block_s * (jacobian.transpose() * jacobian);
    return std::sqrt(information.ldlt().solve(Eigen::VectorXd::Unit(jacobian.cols(), 2))[2]);
}

}  // namespace

WarmupCost costOfStarting(const WarmupFit& fit, double on_s) {
    const Estimate change = fit.mean_change_rad_s(on_s, kNextDrive_s);
    const double room_rad_s = 0.5 * kNextDrive_s * std::abs(fit.room_drift_rad_s2);
    return {std::abs(change.value) + change.margin(), change.margin() + room_rad_s};
}

std::optional<double> knownIn_s(const WarmupFit& fit, double on_before_s, double stood_s) {
    const double now = timeErrorAfter(fit, on_before_s, stood_s);
    for (double times = 1.0; times < kLongestForecast; times *= kForecastStep) {
        const double then = timeErrorAfter(fit, on_before_s, times * stood_s);
        if (fit.relativeErrorOfTime() * then / now <= kKnownTimeError)
            return (times - 1.0) * stood_s;
    }
    return std::nullopt;
}

double settledIn_s(const GyroDrift& curve, double on_s, double matters_rad_s) {
    const double ratio = std::abs(curve.c1_rad_s) / matters_rad_s;
    return ratio <= 1.0 ? 0.0 : std::max(0.0, curve.time_s * std::log(ratio) - on_s);
}

}  // namespace hedr
