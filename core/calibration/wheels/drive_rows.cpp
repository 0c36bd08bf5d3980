#include "core/calibration/wheels/drive_rows.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace hedr {

namespace {

constexpr Eigen::Index kShapeColumns = 2;
constexpr double kKnotSpacing_s = 30.0;
constexpr double kMostKnots = 60.0;

double inverseSquare(double value) { return 1.0 / (value * value); }

}  // namespace

DriveRows::DriveRows(std::span<const DriveLog> logs) {
    Eigen::Index columns = kShapeColumns;
    for (std::size_t log = 0; log < logs.size(); ++log) {
        const std::vector<DrivePiece>& pieces = logs[log].pieces;
        pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
        log_of_.insert(log_of_.end(), pieces.size(), log);
        noises_.push_back(logs[log].noise);
        addKnots(pieces);
        columns += knots_.back().count + 1;
    }
    const auto rows = static_cast<Eigen::Index>(pieces_.size());
    difference_m_.resize(rows);
    design_.setZero(rows, columns);
    for (Eigen::Index row = 0; row < rows; ++row) {
        addRow(row, piece(row), knots_[log_of_[static_cast<std::size_t>(row)]]);
    }
}

const DrivePiece& DriveRows::piece(Eigen::Index row) const {
    return pieces_[static_cast<std::size_t>(row)];
}

const DriveNoise& DriveRows::noise(Eigen::Index row) const {
    return noises_[log_of_[static_cast<std::size_t>(row)]];
}

double DriveRows::gyroVariance_rad2(Eigen::Index row) const {
    const double span_s = piece(row).span_s();
    const double rounding_rad = noise(row).rounding_rad_s * span_s;
    return noise(row).gyro_rad_s_sqrthz * noise(row).gyro_rad_s_sqrthz * span_s +
           rounding_rad * rounding_rad;
}

void DriveRows::addKnots(std::span<const DrivePiece> pieces) {
    Knots knots;
    knots.first = knots_.empty() ? kShapeColumns : knots_.back().first + knots_.back().count + 1;
    knots.spacing_s = kKnotSpacing_s;
    if (!pieces.empty()) {
        knots.begin_s = pieces.front().begin_s;
        const double span_s = pieces.back().end_s - knots.begin_s;
        const double steps = std::clamp(std::ceil(span_s / kKnotSpacing_s), 1.0, kMostKnots);
        knots.spacing_s = span_s / steps;
        knots.count = static_cast<Eigen::Index>(steps) + 1;
    }
    knots_.push_back(knots);
}

void DriveRows::addRow(Eigen::Index row, const DrivePiece& piece, const Knots& knots) {
    difference_m_(row) = piece.difference_m;
    design_(row, 0) = piece.gyro_rad;
    design_(row, 1) = -piece.way_m;
    const double at = (0.5 * (piece.begin_s + piece.end_s) - knots.begin_s) / knots.spacing_s;
    const auto before =
        std::clamp(static_cast<Eigen::Index>(std::floor(at)), Eigen::Index{0}, knots.count - 2);
    const double share = at - static_cast<double>(before);
    design_(row, knots.first + before) = -(1.0 - share) * piece.span_s();
    design_(row, knots.first + before + 1) = -share * piece.span_s();
    design_(row, knots.first + knots.count) = -at * knots.spacing_s * piece.span_s();
}

Eigen::MatrixXd DriveRows::biasPrior(double wheelbase_m) const {
    const Eigen::Index size = design_.cols() - kShapeColumns;
    Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t log = 0; log < knots_.size(); ++log) {
        const Knots& knots = knots_[log];
        const DriveNoise& noise = noises_[log];
        const Eigen::Index first = knots.first - kShapeColumns;
        const Eigen::Index drift = first + knots.count;
        prior(drift, drift) += inverseSquare(wheelbase_m * noise.bias_slope_rad_s2);
        if (knots.count == 0) continue;
        prior(first, first) += inverseSquare(wheelbase_m * noise.bias_rad_s);
        const double step =
            inverseSquare(wheelbase_m * noise.bias_walk_rad_s_sqrts) / knots.spacing_s;
        for (Eigen::Index knot = first; knot + 1 < first + knots.count; ++knot) {
            prior(knot, knot) += step;
            prior(knot + 1, knot + 1) += step;
            prior(knot, knot + 1) -= step;
            prior(knot + 1, knot) -= step;
        }
    }
    return prior;
}

// Noise of the gyro's angle would make the wheelbase come out smaller, in small turns above all: a
// stand tells the bias only, and what the noise adds to the square of each angle is taken off again
// (errors in variables, corrected score).
DriveRows::Equations DriveRows::equations(const Eigen::VectorXd& weights,
                                          double wheelbase_m) const {
    Eigen::MatrixXd design = design_;
    Eigen::VectorXd difference_m = difference_m_;
    double noise_rad2 = 0.0;
    for (Eigen::Index row = 0; row < count(); ++row) {
        if (piece(row).kind == DriveKind::kStand) {
            difference_m(row) -= wheelbase_m * design(row, 0);
            design(row, 0) = 0.0;
        } else {
            noise_rad2 += weights(row) * gyroVariance_rad2(row);
        }
    }
    const Eigen::MatrixXd weighted = weights.asDiagonal() * design;
    Equations equations{design.transpose() * weighted, weighted.transpose() * difference_m};
    equations.information(0, 0) -= noise_rad2;
    const Eigen::Index biases = design.cols() - kShapeColumns;
    equations.information.bottomRightCorner(biases, biases) += biasPrior(wheelbase_m);
    return equations;
}

Eigen::VectorXd DriveRows::solve(const Eigen::VectorXd& weights, double wheelbase_m) const {
    const Equations normal = equations(weights, wheelbase_m);
    return normal.information.ldlt().solve(normal.right_side);
}

Eigen::Matrix2d DriveRows::unsureFromBias(const Eigen::VectorXd& weights,
                                          double wheelbase_m) const {
    const Eigen::Index biases = design_.cols() - kShapeColumns;
    Eigen::VectorXd of_stands = weights;
    for (Eigen::Index row = 0; row < count(); ++row) {
        if (piece(row).kind != DriveKind::kStand) of_stands(row) = 0.0;
    }
    const auto bias_design = design_.rightCols(biases);
    const Eigen::MatrixXd known =
        biasPrior(wheelbase_m) + bias_design.transpose() * (of_stands.asDiagonal() * bias_design);
    const Eigen::MatrixXd shape_columns = Eigen::MatrixXd::Identity(design_.cols(), kShapeColumns);
    const Eigen::MatrixXd gain =
        equations(weights, wheelbase_m).information.ldlt().solve(shape_columns).bottomRows(biases);
    return gain.transpose() * known * gain;
}

Eigen::VectorXd DriveRows::solveBias(const Eigen::VectorXd& weights,
                                     const WheelShape& shape) const {
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(design_.cols());
    solution(0) = shape.wheelbase_m;
    solution(1) = shape.right_larger;
    const Eigen::VectorXd left_over = residuals_m(solution);
    const Eigen::Index biases = design_.cols() - kShapeColumns;
    const Eigen::MatrixXd weighted = weights.asDiagonal() * design_.rightCols(biases);
    Eigen::MatrixXd information = design_.rightCols(biases).transpose() * weighted;
    information += biasPrior(shape.wheelbase_m);
    solution.tail(biases) = information.ldlt().solve(weighted.transpose() * left_over);
    return solution;
}

Eigen::VectorXd DriveRows::residuals_m(const Eigen::VectorXd& solution) const {
    return difference_m_ - design_ * solution;
}

Eigen::VectorXd DriveRows::turned_rad(const Eigen::VectorXd& solution) const {
    const Eigen::Index biases = design_.cols() - kShapeColumns;
    return design_.col(0) + design_.rightCols(biases) * solution.tail(biases) / solution(0);
}

WheelShape DriveRows::shapeOf(const Eigen::VectorXd& solution) {
    return {solution(0), solution(1)};
}

}  // namespace hedr
