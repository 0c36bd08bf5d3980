#include "core/calibration/compass/field_disturbance.h"

#include <cmath>
#include <vector>

#include "core/calibration/compass/compass_errors.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Columns cos, sin of the waves from … to per turn.
MatrixXd wavesOf(const VectorXd& angle_rad, int from, int to) {
    const Index count = to - from + 1;
    MatrixXd waves(angle_rad.size(), 2 * count);
    for (Index wave = 0; wave < count; ++wave) {
        const auto per_turn = static_cast<double>(from + static_cast<int>(wave));
        waves.col(2 * wave) = (per_turn * angle_rad).array().cos();
        waves.col(2 * wave + 1) = (per_turn * angle_rad).array().sin();
    }
    return waves;
}

MatrixXd withConstant(const MatrixXd& columns) {
    MatrixXd design(columns.rows(), columns.cols() + 1);
    design << VectorXd::Ones(columns.rows()), columns;
    return design;
}

VectorXd onlyCounted(const VectorXd& values, const EllipseFit& fit) {
    return (fit.weight.array() > 0.0).select(values, 0.0);
}

FieldPattern patternOf(const MatrixXd& design, Index first, Index count, const VectorXd& values,
                       std::span<const std::size_t> begins) {
    const CorrelatedFit found = fitWithCorrelatedErrors(design, values, begins);
    const VectorXd part =
        design.middleCols(first, count) * found.coefficients.segment(first, count);
    return {rmsOf(part), found.chanceOf(first, count)};
}

// Middle and size of each turn by its own, beside what two waves take in all.
FieldPattern patternOfTurns(const MagneticTurns& turns, const EllipseFit& fit,
                            const VectorXd& distance, std::span<const std::size_t> begins) {
    const std::vector<MagneticPart> parts = partsOf(turns, 2.0 * kPi);
    if (parts.size() < 2) return {};
    const auto count = static_cast<Index>(parts.size());
    const MatrixXd first_wave = withConstant(wavesOf(fit.angle_rad, 1, 1));
    MatrixXd design = MatrixXd::Zero(distance.size(), 3 * count + 2);
    for (Index i = 0; i < count; ++i) {
        const MagneticPart& part = parts[static_cast<std::size_t>(i)];
        const auto from = static_cast<Index>(part.first);
        const auto length = static_cast<Index>(part.last - part.first);
        design.block(from, 3 * i, length, 3) = first_wave.middleRows(from, length);
    }
    design.rightCols(2) = wavesOf(fit.angle_rad, 2, 2);
    return patternOf(design, 0, 3 * count, distance, begins);
}

}  // namespace

FieldDisturbance disturbanceIn(const MagneticTurns& turns, const EllipseFit& fit,
                               const MagnetometerRange& range) {
    const std::vector<std::size_t> begins = turns.readings().begins;
    const VectorXd share = onlyCounted(fit.distance, fit) / fit.radius();
    FieldDisturbance result;
    result.shape = patternOf(withConstant(wavesOf(fit.angle_rad, 1, 5)), 5, 6, share, begins);
    result.turns = patternOfTurns(turns, fit, share, begins);
    if (turns.judge != HeadingJudge::kNone) {
        const VectorXd errors_rad = onlyCounted(headingErrors_rad(turns, range, range), fit);
        result.heading =
            patternOf(withConstant(wavesOf(fit.angle_rad, 1, 4)), 1, 8, errors_rad, begins);
    }
    return result;
}

}  // namespace hedr
