#include "core/calibration/squares/umbmark_solution.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "core/calibration/estimate.h"
#include "core/calibration/squares/umbmark.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kSmallestDiameterRatio = 0.5;
constexpr double kLargestDiameterRatio = 2.0;
constexpr int kMostIterations = 60;
constexpr double kSmallStep = 1e-8;  // some hundredths of a micrometre at the end

// Scales of the believed travel of each wheel and of the believed turns, and their derivatives by
// the diameter ratio.
struct WheelScales {
    double left = 1.0;
    double right = 1.0;
    double left_slope = 0.0;
    double right_slope = 0.0;

    WheelScales(const VehicleGeometry& believed, double diameter_ratio) {
        const VehicleGeometry real = correctedGeometry(believed, diameter_ratio, 1.0);
        left = real.left_wheel_diameter_m / believed.left_wheel_diameter_m;
        right = real.right_wheel_diameter_m / believed.right_wheel_diameter_m;
        const double believed_ratio =
            believed.right_wheel_diameter_m / believed.left_wheel_diameter_m;
        left_slope = -left * believed_ratio / (diameter_ratio * believed_ratio + 1.0);
        right_slope = left + diameter_ratio * left_slope;
    }
};

// A pose, and how it changes with the two ratios.
struct SteeredPose {
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 2> slope = Eigen::Matrix<double, 3, 2>::Zero();

    void advance(double way_m, double turn_rad, const Eigen::RowVector2d& way_slope,
                 const Eigen::RowVector2d& turn_slope) {
        const double half = 0.5 * turn_rad;
        const double direction = pose.z() + half;
        const double chord_m = way_m * (1.0 - half * half / 6.0);  // steps turn by little
        const double c = std::cos(direction);
        const double s = std::sin(direction);
        const Eigen::RowVector2d direction_slope = slope.row(2) + 0.5 * turn_slope;
        pose += Eigen::Vector3d(chord_m * c, chord_m * s, turn_rad);
        slope.row(0) += c * way_slope - chord_m * s * direction_slope;
        slope.row(1) += s * way_slope + chord_m * c * direction_slope;
        slope.row(2) += turn_slope;
    }
};

SteeredPose steered(const SquareRun& run, const VehicleGeometry& believed,
                    const UmbmarkRatios& ratios) {
    const WheelScales scales(believed, ratios.x());
    const double per_wheelbase = 1.0 / (believed.wheelbase_m * ratios.y());
    SteeredPose end;
    for (const WheelTravel& step : run.steps) {
        const double left_m = scales.left * step.left_m;
        const double right_m = scales.right * step.right_m;
        const double left_slope = scales.left_slope * step.left_m;
        const double right_slope = scales.right_slope * step.right_m;
        const double turn_rad = (right_m - left_m) * per_wheelbase;
        end.advance(0.5 * (left_m + right_m), turn_rad, {0.5 * (left_slope + right_slope), 0.0},
                    {(right_slope - left_slope) * per_wheelbase, -turn_rad / ratios.y()});
    }
    return end;
}

std::vector<EndEquation> equationsAt(const UmbmarkRatios& ratios,
                                     std::span<const MeasuredSquare> squares,
                                     const VehicleGeometry& believed) {
    std::vector<EndEquation> equations;
    equations.reserve(squares.size());
    for (const MeasuredSquare& square : squares) {
        equations.push_back(endEquation(square, believed, ratios));
    }
    return equations;
}

double squaresOf(const std::vector<EndEquation>& equations) {
    double sum = 0.0;
    for (const EndEquation& equation : equations) sum += equation.error_m.squaredNorm();
    return sum;
}

Eigen::Vector2d dampedStep(const std::vector<EndEquation>& equations, double damping) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d pull = Eigen::Vector2d::Zero();
    for (const EndEquation& equation : equations) {
        information += equation.jacobian_m.transpose() * equation.jacobian_m;
        pull += equation.jacobian_m.transpose() * equation.error_m;
    }
    information.diagonal() *= 1.0 + damping;
    return information.ldlt().solve(pull);
}

// A closed square closes as well where its corners are taken for turns of 180° or of none: they are
// nearer to 90° than to either.
Interval possibleWheelbaseRatios(std::span<const MeasuredSquare> squares) {
    double corner_rad = 0.0;
    for (const MeasuredSquare& square : squares) {
        corner_rad += square.run->corner_rad / static_cast<double>(squares.size());
    }
    return {corner_rad / radFromDeg(135.0), corner_rad / radFromDeg(45.0)};
}

bool isPossible(const UmbmarkRatios& ratios, const Interval& wheelbase) {
    return ratios.allFinite() && wheelbase.contains(ratios.y()) &&
           ratios.x() > kSmallestDiameterRatio && ratios.x() < kLargestDiameterRatio;
}

UmbmarkSolution solvedFrom(const UmbmarkRatios& start, std::span<const MeasuredSquare> squares,
                           const VehicleGeometry& believed) {
    const Interval wheelbase = possibleWheelbaseRatios(squares);
    UmbmarkSolution best{start, equationsAt(start, squares, believed)};
    double damping = 1e-3;
    for (int i = 0; i < kMostIterations; ++i) {
        const Eigen::Vector2d step = dampedStep(best.equations, damping);
        UmbmarkSolution next{best.ratios + step, {}};
        const bool possible = isPossible(next.ratios, wheelbase);
        if (possible) next.equations = equationsAt(next.ratios, squares, believed);
        if (possible && squaresOf(next.equations) <= squaresOf(best.equations)) {
            best = std::move(next);
            damping *= 0.01;
        } else {
            damping *= 10.0;
        }
        if (step.norm() < kSmallStep) break;
    }
    return best;
}

}  // namespace

EndEquation endEquation(const MeasuredSquare& square, const VehicleGeometry& believed,
                        const UmbmarkRatios& ratios) {
    const SteeredPose end = steered(*square.run, believed, ratios);
    return {Eigen::Vector2d(square.end.way.x, square.end.way.y) - end.pose.head<2>(),
            end.slope.topRows<2>()};
}

UmbmarkSolution solveUmbmark(std::span<const MeasuredSquare> squares,
                             const VehicleGeometry& believed,
                             const std::optional<UmbmarkRatios>& near) {
    if (near) return solvedFrom(*near, squares, believed);
    UmbmarkSolution best;
    double least = std::numeric_limits<double>::infinity();
    const Interval wheelbase = possibleWheelbaseRatios(squares);
    for (const double share : {0.25, 0.5, 0.75}) {
        const double first = wheelbase.low + share * (wheelbase.high - wheelbase.low);
        UmbmarkSolution solution = solvedFrom({1.0, first}, squares, believed);
        const double sum = squaresOf(solution.equations);
        if (sum >= least) continue;
        best = std::move(solution);
        least = sum;
    }
    return best;
}

}  // namespace hedr
