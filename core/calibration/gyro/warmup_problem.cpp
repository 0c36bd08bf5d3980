#include "core/calibration/gyro/warmup_problem.h"

#include <Eigen/QR>
#include <cmath>

namespace hedr {

namespace {

constexpr double kLongestTimes = 30.0;  // of what was seen
constexpr double kShortestBlocks = 0.5;

}  // namespace

Eigen::Index warmupParametersIn(RoomTemperature room) {
    return room == RoomTemperature::kSteady ? kMostWarmupParameters - 1 : kMostWarmupParameters;
}

GyroDrift curveOf(const WarmupParameters& parameters) {
    return {parameters[0], parameters[1], std::exp(parameters[2])};
}

double roomDriftOf(const WarmupParameters& parameters) {
    return parameters.size() == kMostWarmupParameters ? parameters[3] : 0.0;
}

WarmupProblem::WarmupProblem(std::span<const WarmupBlock> blocks, RoomTemperature room)
    : blocks_(blocks), room_(room), root_weights_(rows()) {
    for (Eigen::Index i = 0; i < rows(); ++i)
        root_weights_[i] = std::sqrt(block(i).heard_s / block(i).span_s());
}

double WarmupProblem::shortest_s() const { return kShortestBlocks * blocks_.front().span_s(); }

double WarmupProblem::longest_s() const {
    return kLongestTimes * (blocks_.back().end_s - blocks_.front().begin_s);
}

WarmupParameters WarmupProblem::withoutWarmup(double log_time) const {
    WarmupParameters nothing = WarmupParameters::Zero(parameters());
    nothing[2] = log_time;
    return nothing;
}

WarmupParameters WarmupProblem::bestFor(double time_s) const {
    const WarmupParameters nothing = withoutWarmup(std::log(time_s));
    const Eigen::MatrixXd columns = jacobian(nothing);  // T, of no warming up, has none
    return nothing + columns.colPivHouseholderQr().solve(residuals(nothing));
}

Eigen::VectorXd WarmupProblem::residuals(const WarmupParameters& parameters) const {
    const GyroDrift curve = curveOf(parameters);
    Eigen::VectorXd result(rows());
    for (Eigen::Index i = 0; i < rows(); ++i) {
        result[i] = block(i).mean_rad_s - meanBias(block(i), curve) -
                    roomDriftOf(parameters) * block(i).middle_s();
    }
    return weighted(result);
}

Eigen::MatrixXd WarmupProblem::jacobian(const WarmupParameters& parameters) const {
    return weighted(warmupJacobian(blocks_, curveOf(parameters), room_));
}

Eigen::MatrixXd WarmupProblem::weighted(const Eigen::MatrixXd& columns) const {
    return root_weights_.asDiagonal() * columns;
}

}  // namespace hedr
