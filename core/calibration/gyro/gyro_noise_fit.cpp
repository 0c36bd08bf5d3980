#include "core/calibration/gyro/gyro_noise_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/calibration/distributions.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr std::size_t kFewestPoints = 3;
constexpr std::size_t kFewestAverages = 8;  // fewer say next to nothing
constexpr int kIterations = 12;
constexpr double kSignificance = 2.0;  // standard errors from zero, to be told
constexpr double kPointsPerDecade = 150.0;
constexpr double kMisfitPerCoefficient = 1.5;  // least bias, whatever the truth
constexpr double kZeroByChance = 0.1875;  // intervals hold with and without a little of the others

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Shares of N^2, of B^2 and of K^2 in the variance at one averaging time.
Vector3d sharesAt(double tau_s) {
    return {1.0 / tau_s, 2.0 * std::numbers::ln2 / kPi, tau_s / 3.0};
}

// Two-sided spectrum of the rate.
double spectrumAt(double f_hz, const Vector3d& squares) {
    const double omega = 2.0 * kPi * f_hz;
    return squares[0] + squares[1] / omega + squares[2] / (omega * omega);
}

// How much of the spectrum an Allan variance over `m` samples sees.
double windowAt(double f_hz, double period_s, double m) {
    const double s = std::sin(kPi * f_hz * period_s * m);
    const double d = m * std::sin(kPi * f_hz * period_s);
    return 2.0 * s * s * s * s / (d * d);
}

class Covariances {
  public:
    Covariances(std::span<const AllanPoint> points, double period_s)
        : points_(points), period_s_(period_s) {
        const double longest_s =
            period_s * static_cast<double>(points.front().terms + 2 * points.front().factor);
        const double step = std::log(10.0) / kPointsPerDecade;
        const double highest = std::log(0.5 / period_s);
        for (double f = std::log(0.05 / longest_s); f < highest; f += step) {
            const double f_hz = std::exp(f + 0.5 * step);
            if (f_hz * period_s >= 0.5) break;
            frequencies_hz_.push_back(f_hz);
            widths_hz_.push_back(f_hz * step);
        }
        windows_.resize(static_cast<Eigen::Index>(frequencies_hz_.size()),
                        static_cast<Eigen::Index>(points.size()));
        for (Eigen::Index i = 0; i < windows_.rows(); ++i) {
            for (Eigen::Index j = 0; j < windows_.cols(); ++j) {
                windows_(i, j) = windowAt(frequencies_hz_[static_cast<std::size_t>(i)], period_s,
                                          static_cast<double>(point(j).factor));
            }
        }
    }

    // 2/T times the integral of the squared spectrum over all frequencies, through both windows.
    Eigen::MatrixXd of(const Vector3d& squares) const {
        Eigen::VectorXd weights(windows_.rows());
        for (Eigen::Index i = 0; i < weights.size(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double s = spectrumAt(frequencies_hz_[k], squares);
            weights[i] = 4.0 * s * s * widths_hz_[k];
        }
        Eigen::MatrixXd covariance = windows_.transpose() * weights.asDiagonal() * windows_;
        for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
            for (Eigen::Index j = 0; j < covariance.cols(); ++j)
                covariance(i, j) /= std::max(span_s(i), span_s(j));
        }
        return covariance;
    }

  private:
    const AllanPoint& point(Eigen::Index i) const { return points_[static_cast<std::size_t>(i)]; }
    double span_s(Eigen::Index i) const { return period_s_ * static_cast<double>(point(i).terms); }

    std::span<const AllanPoint> points_;
    double period_s_;
    std::vector<double> frequencies_hz_{};
    std::vector<double> widths_hz_{};
    Eigen::MatrixXd windows_{};
};

struct Squares {
    Vector3d value = Vector3d::Zero();
    double model_error = 0.0;  // a share of each variance
    Matrix3d covariance = Matrix3d::Zero();
    Vector3d with_all = Vector3d::Zero();  // where none is taken for 0
    Vector3d errors_with_all = Vector3d::Zero();
    double misfit = 0.0;
    int kept = 0;  // of the three

    double costs() const { return misfit + kMisfitPerCoefficient * kept; }
};

// Least squares with those of the three that `kept` names; the others are 0.
Squares solve(const Eigen::MatrixXd& shares, const Eigen::VectorXd& variances,
              const Eigen::LLT<Eigen::MatrixXd>& weight, unsigned kept) {
    Squares result;
    std::vector<Eigen::Index> columns;
    for (Eigen::Index c = 0; c < 3; ++c) {
        if ((kept >> static_cast<unsigned>(c)) & 1U) columns.push_back(c);
    }
    const Eigen::MatrixXd a = shares(Eigen::all, columns);
    const Eigen::MatrixXd weighted = weight.solve(a);
    const Eigen::MatrixXd inverse = (a.transpose() * weighted).inverse();
    const Eigen::VectorXd found = inverse * (weighted.transpose() * variances);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        result.value[columns[i]] = found[static_cast<Eigen::Index>(i)];
        for (std::size_t j = 0; j < columns.size(); ++j)
            result.covariance(columns[i], columns[j]) =
                inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
    const Eigen::VectorXd rest = variances - shares * result.value;
    result.misfit = rest.dot(weight.solve(rest));
    result.kept = std::popcount(kept);
    return result;
}

// None of the three can be negative, and one that is hardly more than its standard error is taken
// for 0: else chance, which could only make it positive, would take from the others. N is always
// there. How sure the others are profits from a 0 almost as if it was known.
Squares bestOf(const Eigen::MatrixXd& shares, const Eigen::VectorXd& variances,
               const Eigen::LLT<Eigen::MatrixXd>& weight) {
    const Squares all = solve(shares, variances, weight, 7U);
    std::optional<Squares> best;
    for (const unsigned kept : {7U, 5U, 3U, 1U}) {
        const Squares tried = solve(shares, variances, weight, kept);
        if (tried.value.minCoeff() < 0.0) continue;
        if (!best || tried.costs() < best->costs()) best = tried;
    }
    Squares result = best.value_or(solve(shares, variances, weight, 1U));
    result.with_all = all.value;
    result.errors_with_all = all.covariance.diagonal().cwiseSqrt();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double known = result.covariance(i, i);
        result.covariance(i, i) = known + kZeroByChance * (all.covariance(i, i) - known);
    }
    return result;
}

// Of the root of a square that was found with that variance: the square goes with chi squared,
// whose root is too small on average.
NoiseCoefficient toldCoefficient(double square, double variance) {
    const double degrees = 2.0 * square * square / variance;
    const double root = std::sqrt(square) * (1.0 + 0.25 / degrees);
    const Interval interval{std::sqrt(square * degrees / chiSquaredQuantile(0.975, degrees)),
                            std::sqrt(square * degrees / chiSquaredQuantile(0.025, degrees))};
    return {.found = estimateWithin(root, interval, degrees), .interval = interval};
}

// Where the fall with the root of time begins: a gyro's own filter makes it flatter, coarse steps
// make it steeper. Short records do not tell slopes that well.
std::size_t firstWhite(std::span<const AllanPoint> points) {
    constexpr double kSlopeTolerance = 0.1;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double further = std::log(points[i + 1].tau_s / points[i].tau_s);
        const double slope = std::log(points[i + 1].deviation / points[i].deviation) / further;
        const double unsure =
            std::sqrt(0.5 / points[i].degrees_of_freedom + 0.5 / points[i + 1].degrees_of_freedom) /
            further;
        if (std::abs(slope + 0.5) < kSlopeTolerance + unsure) return i;
    }
    return 0;
}

std::vector<AllanPoint> usable(std::span<const AllanPoint> points) {
    std::vector<AllanPoint> chosen;
    for (const AllanPoint& point : points.subspan(firstWhite(points))) {
        const std::size_t averages = (point.terms + 2 * point.factor) / point.factor;
        if (averages >= kFewestAverages && point.deviation > 0.0) chosen.push_back(point);
    }
    return chosen;
}

Eigen::LLT<Eigen::MatrixXd> weightOf(const Squares& squares, const Eigen::VectorXd& variances,
                                     const Covariances& covariances) {
    Eigen::MatrixXd covariance = covariances.of(squares.value);
    covariance.diagonal() += (squares.model_error * variances).cwiseAbs2();
    return Eigen::LLT<Eigen::MatrixXd>(covariance);
}

// The covariance goes with what is found, so both are found in turns.
std::optional<Squares> fittedWith(const Eigen::MatrixXd& shares, const Eigen::VectorXd& variances,
                                  const Covariances& covariances, double model_error) {
    Squares squares{.model_error = model_error};
    squares.value[0] = variances[0] / shares(0, 0);
    for (int i = 0; i < kIterations; ++i) {
        const auto weight = weightOf(squares, variances, covariances);
        if (weight.info() != Eigen::Success) return std::nullopt;
        squares = bestOf(shares, variances, weight);
        squares.model_error = model_error;
        if (!squares.value.allFinite() || squares.value[0] <= 0.0) return std::nullopt;
    }
    return squares;
}

// A long record shows that no gyro is made of three slopes only. Then every point may be off by a
// share, just so large that the three go with the points.
std::optional<Squares> fitted(const Eigen::MatrixXd& shares, const Eigen::VectorXd& variances,
                              const Covariances& covariances) {
    constexpr double kUnlikely = 0.01;
    constexpr double kLargestModelError = 0.5;
    const auto fits = [&](const Squares& squares) {
        const double degrees = static_cast<double>(variances.size() - squares.kept);
        return chiSquaredTail(squares.misfit, std::max(1.0, degrees)) > kUnlikely;
    };
    auto squares = fittedWith(shares, variances, covariances, 0.0);
    for (double error = 0.01; error < kLargestModelError; error *= 1.5) {
        if (!squares || fits(*squares)) break;
        squares = fittedWith(shares, variances, covariances, error);
    }
    return squares;
}

// What was not told could be as large as this. Were it there, it would make the long averages less
// sure, so its own uncertainty is that with it there. The bound is the upper end of an interval to
// both sides: which of the two is stated goes by the samples, and one to one side would hold less
// often than 95 % of a coefficient that is found now and then (Feldman and Cousins 1998).
double boundOf(Eigen::Index which, Squares squares, const Eigen::MatrixXd& shares,
               const Eigen::VectorXd& variances, const Covariances& covariances) {
    const double found = std::max(0.0, squares.with_all[which]);
    double error = squares.errors_with_all[which];
    const double errors = normalQuantile(0.5 + 0.5 * kUsualConfidence);
    for (int i = 0; i < kIterations; ++i) {
        squares.value[which] = found + errors * error;
        const auto weight = weightOf(squares, variances, covariances);
        if (weight.info() != Eigen::Success) break;
        const double with =
            std::sqrt(solve(shares, variances, weight, 7U).covariance(which, which));
        if (!std::isfinite(with)) break;
        error = std::max(error, with);
    }
    return std::sqrt(found + errors * error);
}

}  // namespace

double GyroNoiseFit::deviation(double tau_s) const {
    const auto square = [](const NoiseCoefficient& c) {
        return c.found ? c.found->value * c.found->value : 0.0;
    };
    const Vector3d squares{square(angle_walk_rad_s_sqrthz), square(instability_rad_s),
                           square(rate_walk_rad_s_sqrts)};
    return std::sqrt(sharesAt(tau_s).dot(squares));
}

std::optional<GyroNoiseFit> fitGyroNoise(std::span<const AllanPoint> points, double period_s) {
    const std::vector<AllanPoint> chosen = usable(points);
    if (chosen.size() < kFewestPoints) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXd shares(n, 3);
    Eigen::VectorXd variances(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const AllanPoint& point = chosen[static_cast<std::size_t>(i)];
        shares.row(i) = sharesAt(point.tau_s).transpose();
        variances[i] = point.deviation * point.deviation;
    }
    const Covariances covariances(chosen, period_s);
    const auto squares = fitted(shares, variances, covariances);
    if (!squares) return std::nullopt;
    const auto of = [&](Eigen::Index i) {
        if (squares->value[i] > kSignificance * squares->errors_with_all[i])
            return toldCoefficient(squares->value[i], squares->covariance(i, i));
        return NoiseCoefficient{{}, {0.0, boundOf(i, *squares, shares, variances, covariances)}};
    };
    return GyroNoiseFit{.angle_walk_rad_s_sqrthz = of(0),
                        .instability_rad_s = of(1),
                        .rate_walk_rad_s_sqrts = of(2),
                        .fitted_from_s = chosen.front().tau_s,
                        .fitted_to_s = chosen.back().tau_s};
}

}  // namespace hedr
