#include "core/calibration/gyro/warmup_curve.h"

#include <cmath>

namespace hedr {

namespace {

// The mean of exp(-t / T) over a block.
double meanDecay(const WarmupBlock& block, double time_s) {
    const double x = block.span_s() / time_s;
    return std::exp(-block.begin_s / time_s) * -std::expm1(-x) / x;
}

// d of it / d ln T
double meanDecaySlope(const WarmupBlock& block, double time_s) {
    const double u = block.begin_s / time_s;
    const double v = block.end_s / time_s;
    return meanDecay(block, time_s) + (u * std::exp(-u) - v * std::exp(-v)) / (v - u);
}

}  // namespace

Eigen::Index warmupParametersIn(RoomTemperature room) {
    return room == RoomTemperature::kSteady ? kMostWarmupParameters - 1 : kMostWarmupParameters;
}

double biasAt(const GyroDrift& curve, double t_s) {
    return curve.c2_rad_s - curve.c1_rad_s * std::expm1(-t_s / curve.time_s);
}

double meanBias(const WarmupBlock& block, const GyroDrift& curve) {
    return curve.c1_rad_s * (1.0 - meanDecay(block, curve.time_s)) + curve.c2_rad_s;
}

Eigen::MatrixXd warmupJacobian(std::span<const WarmupBlock> blocks, const GyroDrift& curve,
                               RoomTemperature room) {
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(blocks.size()), kMostWarmupParameters);
    for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
        const WarmupBlock& block = blocks[static_cast<std::size_t>(i)];
        jacobian.row(i) << 1.0 - meanDecay(block, curve.time_s), 1.0,
            -curve.c1_rad_s * meanDecaySlope(block, curve.time_s), block.middle_s();
    }
    return jacobian.leftCols(warmupParametersIn(room));
}

}  // namespace hedr
