#include "core/calibration/squares/umbmark_scatter.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/calibration/distributions.h"

namespace hedr {

namespace {

// Sums of least squares.
struct NormalEquations {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d pull = Eigen::Vector2d::Zero();
    double squares = 0.0;

    void add(const EndEquation& equation, double sign = 1.0) {
        information += sign * equation.jacobian_m.transpose() * equation.jacobian_m;
        pull += sign * equation.jacobian_m.transpose() * equation.error_m;
        squares += sign * equation.error_m.squaredNorm();
    }
    NormalEquations without(const EndEquation& equation) const {
        NormalEquations rest = *this;
        rest.add(equation, -1.0);
        return rest;
    }
    Eigen::Vector2d step() const { return information.inverse() * pull; }
    double squaresLeft() const { return std::max(0.0, squares - pull.dot(step())); }
};

NormalEquations sumOf(std::span<const EndEquation> equations) {
    NormalEquations sum;
    for (const EndEquation& equation : equations) sum.add(equation);
    return sum;
}

// The chance that an F-distributed ratio with 2 and 2 (ends - 2) degrees of freedom is larger than
// that of these sums of squares: two coordinates, or two ratios, more explain the difference.
double chanceOf(double squares, double squares_with_two_more, double ends) {
    if (squares <= 0.0) return 1.0;
    return std::pow(squares_with_two_more / squares, ends - 2.0);
}

UmbmarkEstimates asEstimates(const UmbmarkRatios& ratios, const Eigen::Vector2d& variance,
                             double degrees_of_freedom) {
    return {.diameter_ratio = {ratios.x(), std::sqrt(variance.x()), degrees_of_freedom},
            .wheelbase_ratio = {ratios.y(), std::sqrt(variance.y()), degrees_of_freedom}};
}

std::size_t sideOf(const MeasuredSquare& square) {
    return square.run->turning == Turning::kCounterClockwise ? 1 : 0;
}

// Two numbers of each square, less their mean over its direction.
struct Deviations {
    std::vector<Eigen::Array2d> values;
    std::array<double, 2> counts{};  // of squares in each direction
    Eigen::Array2d squares = Eigen::Array2d::Zero();

    Deviations(std::vector<Eigen::Array2d> numbers, std::span<const MeasuredSquare> of)
        : values(std::move(numbers)) {
        std::array<Eigen::Array2d, 2> sums{Eigen::Array2d::Zero(), Eigen::Array2d::Zero()};
        for (std::size_t i = 0; i < values.size(); ++i) {
            counts[sideOf(of[i])] += 1.0;
            sums[sideOf(of[i])] += values[i];
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] -= sums[sideOf(of[i])] / counts[sideOf(of[i])];
            squares += values[i].square();
        }
    }
    double degreesOfFreedom() const { return static_cast<double>(values.size()) - 2.0; }
};

// Errors of the ends along the line on which the ratios move them, and across it.
std::vector<Eigen::Array2d> alongAndAcross(std::span<const EndEquation> equations) {
    std::vector<Eigen::Array2d> errors;
    errors.reserve(equations.size());
    for (const EndEquation& equation : equations) {
        const Eigen::Vector2d along = equation.jacobian_m.col(0).normalized();
        const Eigen::Vector2d across(-along.y(), along.x());
        errors.emplace_back(along.dot(equation.error_m), across.dot(equation.error_m));
    }
    return errors;
}

struct Farthest {
    std::size_t index = 0;
    double t = 0.0;  // Student's, of the deviation from the others, by their scatter
    double distance_m = 0.0;
};

Farthest farthestOf(const UmbmarkSolution& solution, std::span<const MeasuredSquare> squares) {
    constexpr double kFewest = 3.0;
    const Deviations deviations(alongAndAcross(solution.equations), squares);
    Farthest farthest;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const double n = deviations.counts[sideOf(squares[i])];
        if (n < kFewest) continue;
        const double as_others = n / (n - 1.0);
        const Eigen::Array2d off = as_others * deviations.values[i];
        const Eigen::Array2d rest = deviations.squares - off.square() / as_others;
        const Eigen::Array2d variance =
            as_others * rest.max(0.0) / (deviations.degreesOfFreedom() - 1.0);
        const double t = (off.abs() / variance.sqrt()).maxCoeff();
        if (t > farthest.t) farthest = {i, t, off.matrix().norm()};
    }
    return farthest;
}

}  // namespace

NearEnds withoutFarEnds(const std::vector<MeasuredSquare>& squares,
                        const VehicleGeometry& believed) {
    constexpr double kChanceOfHonest = 0.01;
    constexpr double kMostShare = 0.3;
    NearEnds near{squares, solveUmbmark(squares, believed), {}};
    NearEnds tried = near;
    const auto most = static_cast<std::size_t>(kMostShare * static_cast<double>(squares.size()));
    while (tried.far.size() < most) {
        const Farthest farthest = farthestOf(tried.solution, tried.squares);
        if (farthest.distance_m == 0.0) break;
        // Two numbers of each square, and both tails.
        const double n = static_cast<double>(tried.squares.size());
        const double surely = studentQuantile(1.0 - kChanceOfHonest / (4.0 * n), n - 3.0);
        const auto at = tried.squares.begin() + static_cast<std::ptrdiff_t>(farthest.index);
        tried.far.push_back({at->run, farthest.distance_m});
        tried.squares.erase(at);
        tried.solution = solveUmbmark(tried.squares, believed, tried.solution.ratios);
        if (farthest.t > surely && farthest.distance_m > kReadingOfTape_m) near = tried;
    }
    return near;
}

DirectionsAgree directionsAgree(const UmbmarkSolution& solution,
                                std::span<const MeasuredSquare> squares) {
    std::array<NormalEquations, 2> directions;
    NormalEquations all;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        directions[sideOf(squares[i])].add(solution.equations[i]);
        all.add(solution.equations[i]);
    }
    const double together = all.squaresLeft();
    const double apart = directions[0].squaresLeft() + directions[1].squaresLeft();
    return {chanceOf(together, apart, static_cast<double>(squares.size())),
            0.5 * std::max(0.0, together - apart)};
}

Eigen::Vector2d metresPerRatio(std::span<const EndEquation> equations) {
    const double n = static_cast<double>(equations.size());
    return (sumOf(equations).information.diagonal() / n).cwiseSqrt();
}

std::vector<UmbmarkRatios> ratiosWithoutEach(const UmbmarkSolution& solution) {
    const auto all = sumOf(solution.equations);
    std::vector<UmbmarkRatios> without;
    without.reserve(solution.equations.size());
    for (const EndEquation& equation : solution.equations) {
        without.emplace_back(solution.ratios + all.without(equation).step());
    }
    return without;
}

UmbmarkEstimates estimatesOf(const UmbmarkSolution& solution,
                             std::span<const MeasuredSquare> squares) {
    const Eigen::Matrix2d covariance = sumOf(solution.equations).information.inverse();
    // What the error of an end does to each ratio is that error along a line, times a length.
    std::vector<Eigen::Array2d> errors;
    Eigen::Array2d lengths = Eigen::Array2d::Zero();
    for (const EndEquation& equation : solution.equations) {
        const Eigen::Matrix2d pull = covariance * equation.jacobian_m.transpose();
        errors.emplace_back((pull * equation.error_m).array() / pull.rowwise().norm().array());
        lengths += pull.rowwise().squaredNorm().array();
    }
    const Deviations deviations(std::move(errors), squares);
    const Eigen::Array2d variance = lengths * deviations.squares / deviations.degreesOfFreedom();
    return asEstimates(solution.ratios, variance.matrix(), deviations.degreesOfFreedom());
}

UmbmarkEstimates estimatesOf(const UmbmarkSolution& solution, const DirectionsAgree& directions) {
    const Eigen::Matrix2d covariance =
        directions.variance_m2 * sumOf(solution.equations).information.inverse();
    return asEstimates(solution.ratios, covariance.diagonal(), 2.0);
}

}  // namespace hedr
