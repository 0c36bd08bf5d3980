#include "core/calibration/gyro/warmup_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/calibration/distributions.h"
#include "core/calibration/gyro/warmup_problem.h"

namespace hedr {

namespace {

using Blocks = std::span<const WarmupBlock>;

constexpr int kStarts = 25;
constexpr int kMostIterations = 30;
constexpr double kFirstDamping = 1e-3;
constexpr double kDampingFactor = 10.0;
constexpr double kSettled = 1e-6;  // squared step, in standard errors
constexpr int kSlowWaves = 6;      // half waves over the record
constexpr double kFurther = 1.3;
constexpr int kHalvings = 20;

// The best of some T, evenly spread over their logarithms.
WarmupParameters startFor(const WarmupProblem& blocks) {
    const double factor = std::pow(blocks.longest_s() / blocks.shortest_s(), 1.0 / (kStarts + 1));
    WarmupParameters best = blocks.withoutWarmup(std::log(blocks.shortest_s()));
    double least = std::numeric_limits<double>::infinity();
    double time_s = blocks.shortest_s();
    for (int i = 0; i < kStarts; ++i) {
        time_s *= factor;
        const WarmupParameters parameters = blocks.bestFor(time_s);
        const double squares = blocks.residuals(parameters).squaredNorm();
        if (squares >= least) continue;
        least = squares;
        best = parameters;
    }
    return best;
}

struct Descent {
    WarmupParameters parameters{};
    int iterations = 0;
    bool converged = false;
};

// By the whole step that is still to go: a damped one may be small anywhere.
bool isSettled(const WarmupProblem& blocks, const Eigen::MatrixXd& jacobian,
               const Eigen::VectorXd& residuals) {
    const Eigen::VectorXd step = jacobian * jacobian.colPivHouseholderQr().solve(residuals);
    return step.squaredNorm() * blocks.degreesOfFreedom() <= kSettled * residuals.squaredNorm();
}

// Levenberg-Marquardt; Marquardt's damping goes by each parameter's own information.
Descent levenbergMarquardt(const WarmupProblem& blocks, const WarmupParameters& start) {
    Descent descent{.parameters = start};
    Eigen::VectorXd residuals = blocks.residuals(start);
    double damping = kFirstDamping;
    while (descent.iterations < kMostIterations && !descent.converged) {
        ++descent.iterations;
        const Eigen::MatrixXd jacobian = blocks.jacobian(descent.parameters);
        Eigen::MatrixXd damped = jacobian.transpose() * jacobian;
        damped.diagonal() *= 1.0 + damping;
        const WarmupParameters step = damped.ldlt().solve(jacobian.transpose() * residuals);
        WarmupParameters next = descent.parameters + step;
        next[2] = std::clamp(next[2], std::log(blocks.shortest_s()), std::log(blocks.longest_s()));
        const Eigen::VectorXd then = blocks.residuals(next);
        descent.converged = isSettled(blocks, jacobian, residuals);
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
double slowMisfitP(const WarmupProblem& blocks, const Eigen::MatrixXd& jacobian,
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

// One end of the interval of T: where the best of all others for a T leaves so much. T is searched
// no further than the fit does.
double endOfTime_s(const WarmupProblem& blocks, double log_time, double step, double limit) {
    const double least = std::log(blocks.shortest_s());
    const double most = std::log(blocks.longest_s());
    const auto leaves = [&](double at) {
        return blocks.residuals(blocks.bestFor(std::exp(at))).squaredNorm();
    };
    double inside = log_time;
    double outside = std::clamp(inside + step, least, most);
    while (leaves(outside) <= limit) {
        if (outside == least || outside == most) return std::exp(outside);
        inside = outside;
        step *= kFurther;
        outside = std::clamp(inside + step, least, most);
    }
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (inside + outside);
        (leaves(middle) <= limit ? inside : outside) = middle;
    }
    return std::exp(inside);
}

// By the likelihood ratio, which also holds where T is hardly known: a longer T bends less and is
// worse to tell, so that it may be further above than below. Venzon and Moolgavkar 1988.
Interval intervalOfTime_s(const WarmupProblem& blocks, const WarmupParameters& parameters,
                          double log_error) {
    const double time_s = std::exp(parameters[2]);
    if (!(log_error > 0.0)) return {time_s, time_s};
    const double degrees = blocks.degreesOfFreedom();
    const double quantile = studentQuantile(0.5 + 0.5 * kUsualConfidence, degrees);
    const double limit =
        blocks.residuals(parameters).squaredNorm() * (1.0 + quantile * quantile / degrees);
    return {endOfTime_s(blocks, parameters[2], -log_error, limit),
            endOfTime_s(blocks, parameters[2], log_error, limit)};
}

WarmupFit fitAt(const WarmupProblem& blocks, const Descent& descent, RoomTemperature room) {
    return {.room = room,
            .curve = blocks.curve(descent.parameters),
            .room_drift_rad_s2 = roomDriftOf(descent.parameters),
            .iterations = descent.iterations,
            .converged = descent.converged};
}

// What a gyro that does not warm up leaves: a bias and what the room makes of it.
double restWithoutWarmup(const WarmupProblem& blocks, const WarmupParameters& parameters) {
    const WarmupParameters nothing = blocks.withoutWarmup(parameters[2]);
    Eigen::MatrixXd columns = blocks.jacobian(nothing);
    columns.col(0).setZero();
    return restOf(columns, blocks.residuals(nothing));
}

void judgeFit(WarmupFit& fit, const WarmupProblem& blocks, const WarmupParameters& parameters) {
    const Eigen::VectorXd residuals = blocks.residuals(parameters);
    const Eigen::MatrixXd jacobian = blocks.jacobian(parameters);
    const Eigen::Index count = blocks.parameters();
    const double squares = residuals.squaredNorm();
    fit.degrees_of_freedom = blocks.degreesOfFreedom();
    const double variance = squares / fit.degrees_of_freedom;
    const Eigen::MatrixXd covariance =
        variance *
        (jacobian.transpose() * jacobian).ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    const Eigen::MatrixXd since = blocks.sinceSwitchedOn(parameters);
    fit.covariance.topLeftCorner(count, count) = since * covariance * since.transpose();
    fit.time_95_s = intervalOfTime_s(blocks, parameters, fit.relativeErrorOfTime());
    fit.slow_misfit_p = slowMisfitP(blocks, jacobian, residuals);
    fit.change_chi_squared = (restWithoutWarmup(blocks, parameters) - squares) / variance;
    fit.residuals_rad_s.assign(residuals.begin(), residuals.end());
}

Eigen::Vector4d derivativeAt(const GyroDrift& curve, double t_s) {
    const double x = t_s / curve.time_s;
    return {-std::expm1(-x), 1.0, -curve.c1_rad_s * x * std::exp(-x), t_s};
}

Estimate projected(const WarmupFit& fit, double value, const Eigen::Vector4d& derivative) {
    const double variance = derivative.dot(fit.covariance * derivative);
    return {value, std::sqrt(std::max(0.0, variance)), fit.degrees_of_freedom};
}

}  // namespace

Estimate WarmupFit::c1_rad_s() const {
    return projected(*this, curve.c1_rad_s, Eigen::Vector4d::UnitX());
}

Estimate WarmupFit::c2_rad_s() const {
    return projected(*this, curve.c2_rad_s, Eigen::Vector4d::UnitY());
}

Estimate WarmupFit::time_s() const {
    return estimateWithin(curve.time_s, time_95_s, degrees_of_freedom);
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

WarmupFit refitWarmup(Blocks blocks, const WarmupFit& near) {
    const WarmupProblem problem(blocks, near.room);
    const auto start = problem.parametersFor(near.curve, near.room_drift_rad_s2);
    return fitAt(problem, levenbergMarquardt(problem, start), near.room);
}

WarmupFit fitWarmup(Blocks blocks, RoomTemperature room) {
    assert(blocks.size() >= kFewestWarmupBlocks);
    const WarmupProblem weighted(blocks, room);
    const Descent descent = levenbergMarquardt(weighted, startFor(weighted));
    WarmupFit fit = fitAt(weighted, descent, room);
    judgeFit(fit, weighted, descent.parameters);
    return fit;
}

}  // namespace hedr
