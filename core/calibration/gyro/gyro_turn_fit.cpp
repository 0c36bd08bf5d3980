#include "core/calibration/gyro/gyro_turn_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/calibration/distributions.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFewestDegrees = 2.0;  // with one, an interval is 13 standard errors wide
constexpr double kTurnsPerOutlier = 4.0;
constexpr double kChanceOfOutlier = 0.01;  // in turns that have none
constexpr double kUsualDegrees = 3.0;      // for so much of a scatter stands the usual one

// Reported per true rate, by directions, and the rest.
struct LeastSquares {
    VectorXd parameters{};
    MatrixXd covariance{};
    MatrixXd weights{};  // parameters = weights * reported
    double chi_squared = 0.0;
};

LeastSquares solve(const MatrixXd& design, const VectorXd& reported, const MatrixXd& covariance) {
    const Eigen::LDLT<MatrixXd> errors(covariance);
    const MatrixXd weighted = errors.solve(design);
    LeastSquares result;
    result.covariance = (design.transpose() * weighted).inverse();
    result.weights = result.covariance * weighted.transpose();
    result.parameters = result.weights * reported;
    const VectorXd rest = reported - design * result.parameters;
    result.chi_squared = rest.dot(errors.solve(rest));
    return result;
}

// A column for each direction that was turned, counter-clockwise first.
MatrixXd directionsOf(const TurnModel& model) {
    const VectorXd left = model.turned_rad.cwiseMax(0.0);
    const VectorXd right = model.turned_rad.cwiseMin(0.0);
    MatrixXd design(left.size(), 0);
    for (const VectorXd& direction : {left, right}) {
        if (direction.isZero()) continue;
        design.conservativeResize(Eigen::NoChange, design.cols() + 1);
        design.rightCols(1) = direction;
    }
    return design;
}

VectorXd columnOf(const TurnModel& model, const TurnOutlier& outlier) {
    VectorXd column = VectorXd::Zero(model.reported_rad.size());
    const auto turn = static_cast<Eigen::Index>(outlier.turn);
    column(turn) = 1.0;
    if (outlier.stand) column(turn + 1) = -1.0;
    return column;
}

MatrixXd withColumn(const MatrixXd& design, const VectorXd& column) {
    MatrixXd wider(design.rows(), design.cols() + 1);
    wider << design, column;
    return wider;
}

MatrixXd designOf(const TurnModel& model, std::span<const TurnOutlier> outliers) {
    MatrixXd design = directionsOf(model);
    for (const TurnOutlier& outlier : outliers) {
        design = withColumn(design, columnOf(model, outlier));
    }
    return design;
}

std::vector<TurnOutlier> suspectsIn(const TurnModel& model) {
    std::vector<TurnOutlier> suspects;
    for (Eigen::Index turn = 0; turn < model.reported_rad.size(); ++turn) {
        suspects.push_back({static_cast<std::size_t>(turn), false});
        const bool goes_on =
            turn + 1 < model.reported_rad.size() && model.marks(turn, turn + 1) != 0.0;
        if (goes_on) suspects.push_back({static_cast<std::size_t>(turn), true});
    }
    return suspects;
}

bool isDetermined(const MatrixXd& design) {
    return design.colPivHouseholderQr().rank() == design.cols();
}

// How many standard errors a suspect is off, as many of them as it may be by chance; below 1: it
// is none. The scatter is that of the others and the usual one together, as few turns tell little.
double strangenessOf(const LeastSquares& fit, double degrees, double suspects) {
    const Eigen::Index last = fit.parameters.size() - 1;
    const double together = kUsualDegrees + degrees;
    const double factor = (kUsualDegrees + fit.chi_squared) / together;
    const double sigmas =
        std::abs(fit.parameters(last)) / std::sqrt(factor * fit.covariance(last, last));
    return sigmas / studentQuantile(1.0 - 0.5 * kChanceOfOutlier / suspects, together);
}

// The suspect that is most certainly off, if any is.
std::optional<TurnOutlier> worstOutlier(const TurnModel& model, const MatrixXd& design) {
    const MatrixXd errors = model.errors();
    const std::vector<TurnOutlier> suspects = suspectsIn(model);
    std::optional<TurnOutlier> worst;
    double strangest = 1.0;
    for (const TurnOutlier& suspect : suspects) {
        const MatrixXd wider = withColumn(design, columnOf(model, suspect));
        const auto degrees = static_cast<double>(wider.rows() - wider.cols());
        if (degrees < 1.0 || !isDetermined(wider)) continue;
        const LeastSquares fit = solve(wider, model.reported_rad, errors);
        const double strangeness =
            strangenessOf(fit, degrees, static_cast<double>(suspects.size()));
        if (strangeness <= strangest) continue;
        strangest = strangeness;
        worst = suspect;
        worst->off_rad = fit.parameters(fit.parameters.size() - 1);
    }
    return worst;
}

std::vector<TurnOutlier> outliersIn(const TurnModel& model) {
    std::vector<TurnOutlier> outliers;
    const auto turns = static_cast<double>(model.reported_rad.size());
    while (static_cast<double>(outliers.size() + 1) * kTurnsPerOutlier <= turns) {
        const auto worst = worstOutlier(model, designOf(model, outliers));
        if (!worst) break;
        outliers.push_back(*worst);
    }
    return outliers;
}

double degreesOfKnown(std::span<const TurnLog> logs) {
    double degrees = 0.0;
    for (const TurnLog& log : logs) degrees += log.standing.degrees_of_freedom;
    return std::max(1.0, degrees);
}

// A sum of parameters. The covariance is right but for a factor, which the scatter tells; but the
// gyro's own noise and bias are known, and the error cannot be smaller than theirs.
Estimate combined(const TurnModel& model, const LeastSquares& fit, const VectorXd& sum,
                  double factor, double degrees) {
    const double value = sum.dot(fit.parameters);
    const VectorXd weights = fit.weights.transpose() * sum;
    const double of_known = weights.dot(model.known * weights);
    const Estimate scattered{value, std::sqrt(factor * sum.dot(fit.covariance * sum)), degrees};
    const Estimate known{value, std::sqrt(of_known), model.known_degrees};
    return scattered.margin() > known.margin() ? scattered : known;
}

// True per reported instead of reported per true.
Estimate inverse(const Estimate& estimate) {
    return {1.0 / estimate.value, estimate.standard_error / (estimate.value * estimate.value),
            estimate.degrees_of_freedom};
}

Estimate scaledBy(const Estimate& estimate, double factor) {
    return {factor * estimate.value, factor * estimate.standard_error, estimate.degrees_of_freedom};
}

double squareOf(double value) { return value * value; }

double biasShareOf(const GyroTurn& turn, std::size_t stand) {
    const bool within = stand >= turn.from && stand <= turn.to;
    return within ? turn.bias_share_s[stand - turn.from] : 0.0;
}

double markShareOf(const GyroTurn& turn, std::size_t stand) {
    return (stand == turn.to ? 1.0 : 0.0) - (stand == turn.from ? 1.0 : 0.0);
}

// What two turns, or one, have of the errors of the stands.
void addShared(TurnModel& model, Eigen::Index i, Eigen::Index j, const GyroTurn& turn,
               const GyroTurn& other, const GyroStands& standing) {
    for (std::size_t stand = turn.from; stand <= turn.to; ++stand) {
        const double mean = squareOf(standing.noise_rad_s_sqrthz) / standing.stands[stand].span_s +
                            squareOf(standing.rounding_rad_s);
        model.known(i, j) += mean * biasShareOf(turn, stand) * biasShareOf(other, stand);
        model.marks(i, j) += markShareOf(turn, stand) * markShareOf(other, stand);
    }
}

}  // namespace

TurnModel turnModelOf(std::span<const TurnLog> logs, std::span<const GyroTurn> turns,
                      double usual_mark_rad) {
    const auto n = static_cast<Eigen::Index>(turns.size());
    TurnModel model{VectorXd(n),          VectorXd(n),          MatrixXd::Zero(n, n),
                    degreesOfKnown(logs), MatrixXd::Zero(n, n), usual_mark_rad};
    for (Eigen::Index i = 0; i < n; ++i) {
        const GyroTurn& turn = turns[static_cast<std::size_t>(i)];
        const GyroStands& standing = logs[turn.log].standing;
        model.reported_rad(i) = turn.reported_rad;
        model.turned_rad(i) = 2.0 * kPi * turn.whole;
        for (Eigen::Index j = 0; j < n; ++j) {
            const GyroTurn& other = turns[static_cast<std::size_t>(j)];
            if (other.log == turn.log) addShared(model, i, j, turn, other, standing);
        }
        model.known(i, i) += squareOf(standing.noise_rad_s_sqrthz) * turn.duration_s;
    }
    return model;
}

TurnFit fitTurns(const TurnModel& model) {
    assert(model.reported_rad.size() > 0);
    TurnFit fit{.outliers = outliersIn(model)};
    const MatrixXd design = designOf(model, fit.outliers);
    const auto degrees = static_cast<double>(design.rows() - design.cols());
    const LeastSquares squares = solve(design, model.reported_rad, model.errors());
    fit.mark_was_given = degrees < kFewestDegrees;
    const double factor = fit.mark_was_given ? 1.0 : squares.chi_squared / degrees;
    fit.mark_rad = model.usual_mark_rad * std::sqrt(factor);
    const double told_degrees =
        fit.mark_was_given ? std::numeric_limits<double>::infinity() : degrees;
    const auto sum_of = [&](double first, double second) {
        VectorXd sum = VectorXd::Zero(design.cols());
        sum(0) = first;
        if (second != 0.0) sum(1) = second;
        return combined(model, squares, sum, factor, told_degrees);
    };
    const bool left = model.turned_rad.maxCoeff() > 0.0;
    const bool right = model.turned_rad.minCoeff() < 0.0;
    if (left) fit.counter_clockwise = inverse(sum_of(1.0, 0.0));
    if (right) fit.clockwise = inverse(left ? sum_of(0.0, 1.0) : sum_of(1.0, 0.0));
    fit.both = inverse(left && right ? sum_of(0.5, 0.5) : sum_of(1.0, 0.0));
    if (left && right) fit.difference = scaledBy(sum_of(-1.0, 1.0), fit.both.value);
    return fit;
}

std::optional<double> scaleWithout(const TurnModel& model, const TurnFit& fit, std::size_t turn) {
    // A turn with a column of its own has no say in the other columns.
    TurnModel others = model;
    others.turned_rad(static_cast<Eigen::Index>(turn)) = 0.0;
    std::vector<TurnOutlier> outliers = fit.outliers;
    const bool is_out = std::any_of(outliers.begin(), outliers.end(), [turn](const auto& outlier) {
        return outlier.turn == turn && !outlier.stand;
    });
    if (!is_out) outliers.push_back({turn, false});
    const MatrixXd design = designOf(others, outliers);
    const auto directions = design.cols() - static_cast<Eigen::Index>(outliers.size());
    if (directions == 0 || !isDetermined(design)) return std::nullopt;
    const LeastSquares squares = solve(design, model.reported_rad, model.errors());
    return 1.0 / squares.parameters.head(directions).mean();
}

}  // namespace hedr
