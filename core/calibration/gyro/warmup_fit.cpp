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
using Parameters = Eigen::Vector3d;  // C1, C2, ln T

// Bounds of T, in what was seen: beyond them nothing bends, or all is over at once.
constexpr double kLongestTimes = 30.0;
constexpr double kShortestBlocks = 0.5;
constexpr int kStarts = 25;
constexpr int kMostIterations = 30;
constexpr double kFirstDamping = 1e-3;
constexpr double kDampingFactor = 10.0;
constexpr double kSettled = 1e-6;  // squared step, in standard errors
constexpr int kSlowWaves = 6;      // half waves over the record

GyroDrift curveOf(const Parameters& parameters) {
    return {parameters[0], parameters[1], std::exp(parameters[2])};
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
    explicit WeightedBlocks(Blocks blocks) : blocks_(blocks), root_weights_(rows()) {
        for (Eigen::Index i = 0; i < rows(); ++i)
            root_weights_[i] = std::sqrt(block(i).heard_s / block(i).span_s());
    }

    Eigen::Index rows() const { return static_cast<Eigen::Index>(blocks_.size()); }
    double shortest_s() const { return kShortestBlocks * blocks_.front().span_s(); }
    double longest_s() const {
        return kLongestTimes * (blocks_.back().end_s - blocks_.front().begin_s);
    }

    Eigen::VectorXd residuals(const Parameters& parameters) const {
        Eigen::VectorXd result(rows());
        for (Eigen::Index i = 0; i < rows(); ++i)
            result[i] = block(i).mean_rad_s - meanBias(block(i), curveOf(parameters));
        return weighted(result);
    }

    Eigen::MatrixXd jacobian(const Parameters& parameters) const {
        return weighted(warmupJacobian(blocks_, curveOf(parameters)));
    }

    Eigen::MatrixXd weighted(const Eigen::MatrixXd& columns) const {
        return root_weights_.asDiagonal() * columns;
    }

  private:
    const WarmupBlock& block(Eigen::Index i) const { return blocks_[static_cast<std::size_t>(i)]; }

    Blocks blocks_;
    Eigen::VectorXd root_weights_;
};

// The best C1 and C2 for a T.
Parameters linearFit(const WeightedBlocks& blocks, double time_s) {
    const Parameters none{0.0, 0.0, std::log(time_s)};
    const Eigen::MatrixXd columns = blocks.jacobian(none).leftCols<2>();
    const Eigen::Vector2d sizes = columns.householderQr().solve(blocks.residuals(none));
    return {sizes[0], sizes[1], none[2]};
}

// The best of some T, evenly spread over their logarithms.
Parameters startFor(const WeightedBlocks& blocks) {
    const double factor = std::pow(blocks.longest_s() / blocks.shortest_s(), 1.0 / (kStarts + 1));
    Parameters best = Parameters::Zero();
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
    Parameters parameters = Parameters::Zero();
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
        const Eigen::Matrix3d information = jacobian.transpose() * jacobian;
        Eigen::Matrix3d damped = information;
        damped.diagonal() *= 1.0 + damping;
        const Parameters step = damped.ldlt().solve(jacobian.transpose() * residuals);
        Parameters next = descent.parameters + step;
        next[2] = std::clamp(next[2], std::log(blocks.shortest_s()), std::log(blocks.longest_s()));
        const Eigen::VectorXd then = blocks.residuals(next);
        const double variance = residuals.squaredNorm() / static_cast<double>(blocks.rows() - 3);
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
    Eigen::MatrixXd all(rows, 3 + kSlowWaves);
    all << jacobian, blocks.weighted(waves);
    const double degrees = static_cast<double>(rows) - 3.0 - kSlowWaves;
    const double ratio = restOf(jacobian, residuals) / restOf(all, residuals);
    const double statistic = (degrees + 0.5 * kSlowWaves - 1.0) * std::log(ratio);
    return statistic > 0.0 ? chiSquaredTail(statistic, kSlowWaves) : 1.0;
}

void judgeFit(WarmupFit& fit, const WeightedBlocks& blocks, const Parameters& parameters) {
    const Eigen::VectorXd residuals = blocks.residuals(parameters);
    const Eigen::MatrixXd jacobian = blocks.jacobian(parameters);
    const double squares = residuals.squaredNorm();
    fit.degrees_of_freedom = static_cast<double>(blocks.rows() - 3);
    const double variance = squares / fit.degrees_of_freedom;
    fit.covariance =
        variance * (jacobian.transpose() * jacobian).ldlt().solve(Eigen::Matrix3d::Identity());
    fit.slow_misfit_p = slowMisfitP(blocks, jacobian, residuals);
    const Eigen::VectorXd means = blocks.residuals({0.0, 0.0, parameters[2]});
    fit.change_chi_squared = (restOf(jacobian.col(1), means) - squares) / variance;
    fit.residuals_rad_s.assign(residuals.begin(), residuals.end());
}

Eigen::Vector3d derivativeAt(const GyroDrift& curve, double t_s) {
    const double x = t_s / curve.time_s;
    return {-std::expm1(-x), 1.0, -curve.c1_rad_s * x * std::exp(-x)};
}

Estimate projected(const WarmupFit& fit, double value, const Eigen::Vector3d& derivative) {
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
    return projected(*this, curve.c1_rad_s, Eigen::Vector3d::UnitX());
}

Estimate WarmupFit::c2_rad_s() const {
    return projected(*this, curve.c2_rad_s, Eigen::Vector3d::UnitY());
}

Estimate WarmupFit::time_s() const {
    return projected(*this, curve.time_s, {0.0, 0.0, curve.time_s});
}

Estimate WarmupFit::bias_rad_s(double t_s) const {
    return projected(*this, biasAt(curve, t_s), derivativeAt(curve, t_s));
}

Estimate WarmupFit::mean_change_rad_s(double t_s, double span_s) const {
    const WarmupBlock later[] = {{.begin_s = t_s, .end_s = t_s + span_s}};
    const Eigen::Vector3d derivative =
        warmupJacobian(later, curve).row(0).transpose() - derivativeAt(curve, t_s);
    return projected(*this, meanBias(later[0], curve) - biasAt(curve, t_s), derivative);
}

double WarmupFit::relativeErrorOfTime() const { return std::sqrt(covariance(2, 2)); }

Eigen::MatrixXd warmupJacobian(Blocks blocks, const GyroDrift& curve) {
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(blocks.size()), 3);
    for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
        const WarmupBlock& block = blocks[static_cast<std::size_t>(i)];
        jacobian.row(i) << 1.0 - meanDecay(block, curve.time_s), 1.0,
            -curve.c1_rad_s * meanDecaySlope(block, curve.time_s);
    }
    return jacobian;
}

GyroDrift refitWarmup(Blocks blocks, const GyroDrift& start) {
    const Parameters near{start.c1_rad_s, start.c2_rad_s, std::log(start.time_s)};
    return curveOf(levenbergMarquardt(WeightedBlocks(blocks), near).parameters);
}

WarmupFit fitWarmup(Blocks blocks) {
    assert(blocks.size() >= kFewestWarmupBlocks);
    const WeightedBlocks weighted(blocks);
    const Descent descent = levenbergMarquardt(weighted, startFor(weighted));
    WarmupFit fit{.curve = curveOf(descent.parameters),
                  .iterations = descent.iterations,
                  .converged = descent.converged};
    judgeFit(fit, weighted, descent.parameters);
    return fit;
}

}  // namespace hedr
