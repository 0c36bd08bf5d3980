#include "core/calibration/compass/compass_errors.h"

#include <Eigen/QR>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/robot/level_field.h"

namespace hedr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kCircleSteps = 72;
constexpr double kGoesRound = 0.5;  // of a turn that it may go round more or less often

MagneticField fieldOf(const MagneticSample& sample) {
    return {sample.field.x(), sample.field.y(), sample.field.z()};
}

VectorXd magneticHeadings_rad(const MagneticTurns& turns, const MagnetometerRange& range) {
    VectorXd headings(static_cast<Index>(turns.samples.size()));
    for (Index i = 0; i < headings.size(); ++i) {
        const MagneticSample& sample = turns.samples[static_cast<std::size_t>(i)];
        headings(i) = withoutIron(fieldOf(sample), range).heading_rad();
    }
    return headings;
}

// Without jumps within each stretch.
void unwrap(VectorXd& headings, const MagneticTurns& turns) {
    for (const MagneticStretch& stretch : turns.stretches) {
        for (std::size_t i = stretch.first + 1; i < stretch.last; ++i) {
            const auto now = static_cast<Index>(i);
            headings(now) = headings(now - 1) + wrapAngle(headings(now) - headings(now - 1));
        }
    }
}

double windingOf(const VectorXd& unwrapped, const MagneticStretch& stretch) {
    return unwrapped(static_cast<Index>(stretch.last - 1)) -
           unwrapped(static_cast<Index>(stretch.first));
}

bool goesRoundAsOften(const VectorXd& unwrapped, const VectorXd& other,
                      const MagneticTurns& turns) {
    for (const MagneticStretch& stretch : turns.stretches) {
        const double more_rad = windingOf(unwrapped, stretch) - windingOf(other, stretch);
        if (std::abs(more_rad) > kGoesRound * 2.0 * kPi) return false;
    }
    return true;
}

// The judge's heading with scale, bias and a constant of each stretch that fit `headings` best.
VectorXd judgedHeadings_rad(const VectorXd& headings, const MagneticTurns& turns) {
    const auto stretches = static_cast<Index>(turns.stretches.size());
    MatrixXd design = MatrixXd::Zero(headings.size(), stretches + 2);
    const double begin_s = turns.samples.front().t_s;
    for (Index j = 0; j < stretches; ++j) {
        const MagneticStretch& stretch = turns.stretches[static_cast<std::size_t>(j)];
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            const auto row = static_cast<Index>(i);
            design(row, 0) = turns.samples[i].turned_rad;
            design(row, 1) = turns.samples[i].t_s - begin_s;
            design(row, j + 2) = 1.0;
        }
    }
    // At a steady rate scale and bias are one, which does not matter here.
    return design * design.colPivHouseholderQr().solve(headings);
}

// A constant of each stretch off, by the circular mean.
void removeConstants(VectorXd& errors, const MagneticTurns& turns) {
    for (const MagneticStretch& stretch : turns.stretches) {
        double sine = 0.0;
        double cosine = 0.0;
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            sine += std::sin(errors(static_cast<Index>(i)));
            cosine += std::cos(errors(static_cast<Index>(i)));
        }
        const double mean_rad = std::atan2(sine, cosine);
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            double& error = errors(static_cast<Index>(i));
            error = wrapAngle(error - mean_rad);
        }
    }
}

FieldReadings readingsWithout(const MagneticTurns& turns, const MagneticPart& part) {
    FieldReadings readings = turns.readings();
    const auto first = readings.field.begin() + static_cast<std::ptrdiff_t>(part.first);
    const auto last = readings.field.begin() + static_cast<std::ptrdiff_t>(part.last);
    readings.field.erase(first, last);
    return readings;
}

double rmsWithin(const VectorXd& errors, const MagneticPart& part) {
    return rmsOf(
        errors.segment(static_cast<Index>(part.first), static_cast<Index>(part.last - part.first)));
}

Ellipse nudged(const Ellipse& ellipse, int number, double by) {
    MagnetometerRange range = rangeOf(ellipse);
    double* const numbers[] = {&range.centre_x, &range.centre_y, &range.range_x, &range.range_y,
                               &range.correlation};
    *numbers[number] += by;
    return ellipseFrom(range);
}

// Over the circle of `truth`, with the mean taken off.
VectorXd headingErrorsOverCircle_rad(const Ellipse& truth, const MagnetometerRange& range,
                                     const MagnetometerRange& true_range) {
    VectorXd errors(kCircleSteps);
    double sine = 0.0;
    double cosine = 0.0;
    for (int i = 0; i < kCircleSteps; ++i) {
        const Eigen::Vector2d at = truth.at(2.0 * kPi * i / kCircleSteps);
        const MagneticField field{at.x(), at.y(), 0.0};
        errors(i) =
            withoutIron(field, range).heading_rad() - withoutIron(field, true_range).heading_rad();
        sine += std::sin(errors(i));
        cosine += std::cos(errors(i));
    }
    const double mean_rad = std::atan2(sine, cosine);
    for (double& error : errors) error = wrapAngle(error - mean_rad);
    return errors;
}

}  // namespace

double rmsOf(const VectorXd& values) {
    return values.size() == 0 ? 0.0 : values.norm() / std::sqrt(static_cast<double>(values.size()));
}

VectorXd headingErrors_rad(const MagneticTurns& turns, const MagnetometerRange& range,
                           const MagnetometerRange& reference) {
    VectorXd headings = magneticHeadings_rad(turns, range);
    VectorXd expected = magneticHeadings_rad(turns, reference);
    unwrap(headings, turns);
    unwrap(expected, turns);
    const bool goes_round = goesRoundAsOften(headings, expected, turns);
    VectorXd errors = headings - judgedHeadings_rad(goes_round ? headings : expected, turns);
    removeConstants(errors, turns);
    return errors;
}

VectorXd strengthErrors(const MagneticTurns& turns, const MagnetometerRange& range) {
    VectorXd strengths(static_cast<Index>(turns.samples.size()));
    for (Index i = 0; i < strengths.size(); ++i) {
        const MagneticSample& sample = turns.samples[static_cast<std::size_t>(i)];
        strengths(i) = withoutIron(fieldOf(sample), range).strength();
    }
    return strengths.array() / strengths.mean() - 1.0;
}

double headingErrorOverCircle_rad(const MagnetometerRange& range, const MagnetometerRange& truth) {
    return rmsOf(headingErrorsOverCircle_rad(ellipseFrom(truth), range, truth));
}

double expectedHeadingError_rad(const EllipseFit& fit) {
    MatrixXd slopes(kCircleSteps, 5);
    const double step = 1e-4;
    const double radius = fit.radius();
    const MagnetometerRange found = rangeOf(fit.ellipse);
    for (int number = 0; number < 5; ++number) {
        const double by = number == 4 ? step : step * radius;
        const MagnetometerRange other = rangeOf(nudged(fit.ellipse, number, by));
        slopes.col(number) = headingErrorsOverCircle_rad(fit.ellipse, other, found) / by;
    }
    const double squares = (slopes * fit.covariance * slopes.transpose()).trace();
    return std::sqrt(squares / kCircleSteps);
}

std::vector<HeldOutError> compassHeldOut(const MagneticTurns& turns, const Ellipse& all,
                                         const MagnetometerRange& old,
                                         const MagnetometerRange& signs) {
    const MagnetometerRange reference = withSignsOf(rangeOf(all), signs);
    const bool by_heading = turns.judge != HeadingJudge::kNone;
    const auto errors_of = [&](const MagnetometerRange& range) {
        return by_heading ? headingErrors_rad(turns, range, reference)
                          : strengthErrors(turns, range);
    };
    const VectorXd before = errors_of(old);
    std::vector<HeldOutError> errors;
    for (const MagneticPart& part : heldOutPartsOf(turns)) {
        const auto without = settledEllipse(readingsWithout(turns, part).field, all);
        if (!without) continue;
        const VectorXd after = errors_of(withSignsOf(rangeOf(*without), signs));
        errors.push_back({rmsWithin(before, part), rmsWithin(after, part)});
    }
    return errors;
}

MagnetometerRange withSignsOf(MagnetometerRange range, const MagnetometerRange& signs) {
    const bool other_way =
        (range.range_x * range.range_y < 0.0) != (signs.range_x * signs.range_y < 0.0);
    range.range_x = std::copysign(range.range_x, signs.range_x);
    range.range_y = std::copysign(range.range_y, signs.range_y);
    if (other_way) range.correlation = -range.correlation;
    return range;
}

}  // namespace hedr
