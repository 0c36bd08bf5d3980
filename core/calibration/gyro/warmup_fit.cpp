#include "core/calibration/gyro/warmup_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/calibration/distributions.h"

namespace hedr {

namespace {

using Blocks = std::span<const WarmupBlock>;
using Parameters = Eigen::VectorXd;  // C1, C2, ln T and, where it may be one, the room's drift

// Bounds of T, in what was seen: beyond them nothing bends, or all is over at once.
constexpr double kLongestTimes = 30.0;
constexpr double kShortestBlocks = 0.5;
constexpr int kStarts = 25;
constexpr int kMostIterations = 30;
constexpr double kFirstDamping = 1e-3;
constexpr double kDampingFactor = 10.0;
constexpr double kSettled = 1e-6;  // squared step, in standard errors
constexpr int kSlowWaves = 6;      // half waves over the record

constexpr Eigen::Index kMostParameters = 4;

Eigen::Index parametersOf(RoomTemperature room) {
    return room == RoomTemperature::kSteady ? kMostParameters - 1 : kMostParameters;
}

GyroDrift curveOf(const Parameters& parameters) {
    return {parameters[0], parameters[1], std::exp(parameters[2])};
}

double roomDriftOf(const Parameters& parameters) {
    return parameters.size() == kMostParameters ? parameters[3] : 0.0;
}

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

// The blocks as a problem of least squares in which all rows are equally sure.
class WeightedBlocks {
  public:
    WeightedBlocks(Blocks blocks, RoomTemperature room)
        : blocks_(blocks), room_(room), root_weights_(rows()) {
        for (Eigen::Index i = 0; i < rows(); ++i)
            root_weights_[i] = std::sqrt(block(i).heard_s / block(i).span_s());
    }

    Eigen::Index rows() const { return static_cast<Eigen::Index>(blocks_.size()); }
    Eigen::Index parameters() const { return parametersOf(room_); }
    double degreesOfFreedom() const { return static_cast<double>(rows() - parameters()); }
    double shortest_s() const { return kShortestBlocks * blocks_.front().span_s(); }
    double longest_s() const {
        return kLongestTimes * (blocks_.back().end_s - blocks_.front().begin_s);
    }

    Eigen::VectorXd residuals(const Parameters& parameters) const {
        Eigen::VectorXd result(rows());
        for (Eigen::Index i = 0; i < rows(); ++i) {
            result[i] = block(i).mean_rad_s - meanBias(block(i), curveOf(parameters)) -
                        roomDriftOf(parameters) * block(i).middle_s();
        }
        return weighted(result);
    }

    Eigen::MatrixXd jacobian(const Parameters& parameters) const {
        return weighted(warmupJacobian(blocks_, curveOf(parameters), room_));
    }

    Eigen::MatrixXd weighted(const Eigen::MatrixXd& columns) const {
        return root_weights_.asDiagonal() * columns;
    }

  private:
    const WarmupBlock& block(Eigen::Index i) const { return blocks_[static_cast<std::size_t>(i)]; }

    Blocks blocks_;
    RoomTemperature room_;
    Eigen::VectorXd root_weights_;
};

// No warming up, no bias.
Parameters nothingWithin(const WeightedBlocks& blocks, double log_time) {
    Parameters nothing = Parameters::Zero(blocks.parameters());
    nothing[2] = log_time;
    return nothing;
}

// The best of all others for a T.
Parameters linearFit(const WeightedBlocks& blocks, double time_s) {
    const Parameters nothing = nothingWithin(blocks, std::log(time_s));
    const Eigen::MatrixXd columns = blocks.jacobian(nothing);  // T, of no warming up, has none
    return nothing + columns.colPivHouseholderQr().solve(blocks.residuals(nothing));
}

// The best of some T, evenly spread over their logarithms.
Parameters startFor(const WeightedBlocks& blocks) {
    const double factor = std::pow(blocks.longest_s() / blocks.shortest_s(), 1.0 / (kStarts + 1));
    Parameters best = nothingWithin(blocks, std::log(blocks.shortest_s()));
    double least = std::numeric_limits<double>::infinity();
    double time_s = blocks.shortest_s();
    for (int i = 0; i < kStarts; ++i) {
        time_s *= factor;
        const Parameters parameters = linearFit(blocks, time_s);
        const double squares = blocks.residuals(parameters).squaredNorm();
        if (squares >= least) continue;
        least = squares;
        best = parameters;
    }
    return best;
}

struct Descent {
    Parameters parameters{};
    int iterations = 0;
    bool converged = false;
};

// Levenberg-Marquardt; Marquardt's damping goes by each parameter's own information.
Descent levenbergMarquardt(const WeightedBlocks& blocks, const Parameters& start) {
    Descent descent{.parameters = start};
    Eigen::VectorXd residuals = blocks.residuals(start);
    double damping = kFirstDamping;
    while (descent.iterations < kMostIterations && !descent.converged) {
        ++descent.iterations;
        const Eigen::MatrixXd jacobian = blocks.jacobian(descent.parameters);
        const Eigen::MatrixXd information = jacobian.transpose() * jacobian;
        Eigen::MatrixXd damped = information;
        damped.diagonal() *= 1.0 + damping;
        const Parameters step = damped.ldlt().solve(jacobian.transpose() * residuals);
        Parameters next = descent.parameters + step;
        next[2] = std::clamp(next[2], std::log(blocks.shortest_s()), std::log(blocks.longest_s()));
        const Eigen::VectorXd then = blocks.residuals(next);
        const double variance = residuals.squaredNorm() / blocks.degreesOfFreedom();
        descent.converged = step.dot(information * step) <= kSettled * variance;
        if (then.squaredNorm() > residuals.squaredNorm()) {
            damping *= kDampingFactor;
            continue;
        }
        damping /= kDampingFactor;
        descent.parameters = next;
        residuals = then;
    }
    return descent;
}

double restOf(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residuals) {
    return (residuals - columns * columns.colPivHouseholderQr().solve(residuals)).squaredNorm();
}

// Whether slow cosines explain more of the residuals than noise lets them: a likelihood ratio with
// Bartlett's correction. Whiteness at single lags hardly sees what is slow and small.
double slowMisfitP(const WeightedBlocks& blocks, const Eigen::MatrixXd& jacobian,
                   const Eigen::VectorXd& residuals) {
    const Eigen::Index rows = blocks.rows();
    Eigen::MatrixXd waves(rows, kSlowWaves);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const double phase =
            std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(rows);
        for (int k = 0; k < kSlowWaves; ++k) waves(i, k) = std::cos((k + 1) * phase);
    }
    Eigen::MatrixXd all(rows, jacobian.cols() + kSlowWaves);
    all << jacobian, blocks.weighted(waves);
    const double degrees = blocks.degreesOfFreedom() - kSlowWaves;
    const double ratio = restOf(jacobian, residuals) / restOf(all, residuals);
    const double statistic = (degrees + 0.5 * kSlowWaves - 1.0) * std::log(ratio);
    return statistic > 0.0 ? chiSquaredTail(statistic, kSlowWaves) : 1.0;
}

WarmupFit fitAt(const Descent& descent, RoomTemperature room) {
    return {.room = room,
            .curve = curveOf(descent.parameters),
            .room_drift_rad_s2 = roomDriftOf(descent.parameters),
            .iterations = descent.iterations,
            .converged = descent.converged};
}

// What a gyro that does not warm up leaves: a bias and what the room makes of it.
double restWithoutWarmup(const WeightedBlocks& blocks, const Parameters& parameters) {
    const Parameters nothing = nothingWithin(blocks, parameters[2]);
    Eigen::MatrixXd columns = blocks.jacobian(nothing);
    columns.col(0).setZero();
    return restOf(columns, blocks.residuals(nothing));
}

void judgeFit(WarmupFit& fit, const WeightedBlocks& blocks, const Parameters& parameters) {
    const Eigen::VectorXd residuals = blocks.residuals(parameters);
    const Eigen::MatrixXd jacobian = blocks.jacobian(parameters);
    const Eigen::Index count = blocks.parameters();
    const double squares = residuals.squaredNorm();
    fit.degrees_of_freedom = blocks.degreesOfFreedom();
    const double variance = squares / fit.degrees_of_freedom;
    fit.covariance.topLeftCorner(count, count) =
        variance *
        (jacobian.transpose() * jacobian).ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    fit.slow_misfit_p = slowMisfitP(blocks, jacobian, residuals);
    fit.change_chi_squared = (restWithoutWarmup(blocks, parameters) - squares) / variance;
    fit.residuals_rad_s.assign(residuals.begin(), residuals.end());
}

Eigen::Vector4d derivativeAt(const GyroDrift& curve, double t_s) {
    const double x = t_s / curve.time_s;
    return {-std::expm1(-x), 1.0, -curve.c1_rad_s * x * std::exp(-x), t_s};
}

Estimate projected(const WarmupFit& fit, double value, const Eigen::Vector4d& derivative) {
    return {value, std::sqrt(derivative.dot(fit.covariance * derivative)), fit.degrees_of_freedom};
}

}  // namespace

double meanBias(const WarmupBlock& block, const GyroDrift& curve) {
    return curve.c1_rad_s * (1.0 - meanDecay(block, curve.time_s)) + curve.c2_rad_s;
}

double biasAt(const GyroDrift& curve, double t_s) {
    return curve.c2_rad_s - curve.c1_rad_s * std::expm1(-t_s / curve.time_s);
}

Estimate WarmupFit::c1_rad_s() const {
    return projected(*this, curve.c1_rad_s, Eigen::Vector4d::UnitX());
}

Estimate WarmupFit::c2_rad_s() const {
    return projected(*this, curve.c2_rad_s, Eigen::Vector4d::UnitY());
}

Estimate WarmupFit::time_s() const {
    return projected(*this, curve.time_s, {0.0, 0.0, curve.time_s, 0.0});
}

Estimate WarmupFit::room_rad_s2() const {
    return projected(*this, room_drift_rad_s2, Eigen::Vector4d::UnitW());
}

Estimate WarmupFit::bias_rad_s(double t_s) const {
    return projected(*this, biasAt(curve, t_s) + room_drift_rad_s2 * t_s, derivativeAt(curve, t_s));
}

Estimate WarmupFit::mean_change_rad_s(double t_s, double span_s) const {
    const WarmupBlock later[] = {{.begin_s = t_s, .end_s = t_s + span_s}};
    const Eigen::Vector4d derivative =
        warmupJacobian(later, curve, RoomTemperature::kMayChange).row(0).transpose() -
        derivativeAt(curve, t_s);
    const double change_rad_s =
        meanBias(later[0], curve) - biasAt(curve, t_s) + 0.5 * room_drift_rad_s2 * span_s;
    return projected(*this, change_rad_s, derivative);
}

double WarmupFit::relativeErrorOfTime() const { return std::sqrt(covariance(2, 2)); }

Eigen::MatrixXd warmupJacobian(Blocks blocks, const GyroDrift& curve, RoomTemperature room) {
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(blocks.size()), kMostParameters);
    for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
        const WarmupBlock& block = blocks[static_cast<std::size_t>(i)];
        jacobian.row(i) << 1.0 - meanDecay(block, curve.time_s), 1.0,
            -curve.c1_rad_s * meanDecaySlope(block, curve.time_s), block.middle_s();
    }
    return jacobian.leftCols(parametersOf(room));
}

WarmupFit refitWarmup(Blocks blocks, const WarmupFit& near) {
    Parameters start(kMostParameters);
    start << near.curve.c1_rad_s, near.curve.c2_rad_s, std::log(near.curve.time_s),
        near.room_drift_rad_s2;
    start.conservativeResize(parametersOf(near.room));
    return fitAt(levenbergMarquardt(WeightedBlocks(blocks, near.room), start), near.room);
}

WarmupFit fitWarmup(Blocks blocks, RoomTemperature room) {
    assert(blocks.size() >= kFewestWarmupBlocks);
    const WeightedBlocks weighted(blocks, room);
    const Descent descent = levenbergMarquardt(weighted, startFor(weighted));
    WarmupFit fit = fitAt(descent, room);
    judgeFit(fit, weighted, descent.parameters);
    return fit;
}

}  // namespace hedr
