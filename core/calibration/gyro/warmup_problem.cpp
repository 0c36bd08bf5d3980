#include "core/calibration/gyro/warmup_problem.h"

#include <Eigen/QR>
#include <cmath>

namespace hedr {

namespace {

constexpr double kLongestTimes = 30.0;  // of what was seen
constexpr double kShortestBlocks = 0.5;

// By the record's own time.
GyroDrift curveOf(const WarmupParameters& parameters) {
    return {parameters[0], parameters[1], std::exp(parameters[2])};
}

}  // namespace

double roomDriftOf(const WarmupParameters& parameters) {
    return parameters.size() == kMostWarmupParameters ? parameters[3] : 0.0;
}

WarmupProblem::WarmupProblem(std::span<const WarmupBlock> blocks, RoomTemperature room)
    : on_before_s_(blocks.front().begin_s),
      blocks_(blocks.begin(), blocks.end()),
      room_(room),
      root_weights_(rows()) {
    for (WarmupBlock& block : blocks_) {
        block.begin_s -= on_before_s_;
        block.end_s -= on_before_s_;
    }
    for (Eigen::Index i = 0; i < rows(); ++i)
        root_weights_[i] = std::sqrt(block(i).heard_s / block(i).span_s());
}

GyroDrift WarmupProblem::curve(const WarmupParameters& parameters) const {
    const auto [c1_rad_s, c2_rad_s, time_s] = curveOf(parameters);
    const double cold_c1_rad_s = c1_rad_s * std::exp(on_before_s_ / time_s);
    const double room_rad_s = roomDriftOf(parameters) * on_before_s_;
    return {cold_c1_rad_s, c2_rad_s + c1_rad_s - cold_c1_rad_s - room_rad_s, time_s};
}

WarmupParameters WarmupProblem::parametersFor(const GyroDrift& curve,
                                              double room_drift_rad_s2) const {
    const double c1_rad_s = curve.c1_rad_s * std::exp(-on_before_s_ / curve.time_s);
    const double room_rad_s = room_drift_rad_s2 * on_before_s_;
    WarmupParameters result(kMostWarmupParameters);
    result << c1_rad_s, curve.c2_rad_s + curve.c1_rad_s - c1_rad_s + room_rad_s,
        std::log(curve.time_s), room_drift_rad_s2;
    result.conservativeResize(parameters());
    return result;
}

Eigen::MatrixXd WarmupProblem::sinceSwitchedOn(const WarmupParameters& parameters) const {
    const double times = on_before_s_ / std::exp(parameters[2]);
    const double growth = std::exp(times);
    const double slope = parameters[0] * growth * times;
    Eigen::Matrix4d all;
    all << growth, 0.0, -slope, 0.0,              //
        1.0 - growth, 1.0, slope, -on_before_s_,  //
        0.0, 0.0, 1.0, 0.0,                       //
        0.0, 0.0, 0.0, 1.0;
    return all.topLeftCorner(parameters.size(), parameters.size());
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
