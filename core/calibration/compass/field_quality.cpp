#include "core/calibration/compass/field_quality.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/calibration/compass/compass_errors.h"
#include "core/calibration/short_number.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kSectors = 36.0;

Eigen::ArrayXd countedOnes(const EllipseFit& fit) {
    return (fit.weight.array() > 0.0).cast<double>();
}

double rmsOfCounted(const Eigen::ArrayXd& values, const Eigen::ArrayXd& counts) {
    return std::sqrt((counts * values.square()).sum() / std::max(1.0, counts.sum()));
}

double gapsOfCircle(const EllipseFit& fit) {
    std::vector<bool> seen(static_cast<std::size_t>(kSectors), false);
    for (Eigen::Index i = 0; i < fit.angle_rad.size(); ++i) {
        if (fit.weight(i) <= 0.0) continue;
        const double turns = fit.angle_rad(i) / (2.0 * kPi);
        const double sector = (turns - std::floor(turns)) * kSectors;
        seen[std::min(seen.size() - 1, static_cast<std::size_t>(sector))] = true;
    }
    return static_cast<double>(std::count(seen.begin(), seen.end(), false)) / kSectors;
}

std::optional<double> wobbleOf(const MagneticTurns& turns, const EllipseFit& fit) {
    Eigen::VectorXd vertical(fit.angle_rad.size());
    Eigen::MatrixXd design(vertical.size(), 5);
    const Eigen::ArrayXd counts = countedOnes(fit);
    for (Eigen::Index i = 0; i < vertical.size(); ++i) {
        vertical(i) = turns.samples[static_cast<std::size_t>(i)].field.z();
        const double angle_rad = fit.angle_rad(i);
        design.row(i) << 1.0, std::cos(angle_rad), std::sin(angle_rad), std::cos(2.0 * angle_rad),
            std::sin(2.0 * angle_rad);
        design.row(i) *= counts(i);
    }
    if (vertical.maxCoeff() == vertical.minCoeff()) return std::nullopt;
    const Eigen::VectorXd counted = vertical.cwiseProduct(counts.matrix());
    const Eigen::VectorXd rest = counted - design * design.colPivHouseholderQr().solve(counted);
    return rmsOfCounted(rest.array(), counts) / fit.radius();
}

}  // namespace

std::string FieldQuality::complaint() const {
    if (gaps > kMostGaps) {
        return percentText(gaps) +
               " of the circle was not seen. Turn it on the spot by two whole "
               "turns or more.";
    }
    const bool tilts =
        tilt_error > 0.5 * std::max(fit_error, variance) || (wobble && *wobble > kMostWobble);
    if (tilts && (fit_error > kMostFitError || variance > kMostVariance ||
                  (wobble && *wobble > kMostWobble))) {
        return "It tilted while it turned, by which the field is unsteady by " +
               percentText(std::max(fit_error, tilt_error)) + ". Turn it on level ground.";
    }
    if (outliers > kMostOutliers || fit_error > kMostFitError || variance > kMostVariance) {
        return "The field does not lie on an ellipse (" +
               percentText(std::max(fit_error, variance)) +
               " off). Move away from iron and electric lines, and turn again.";
    }
    return {};
}

FieldQuality fieldQualityOf(const MagneticTurns& turns, const EllipseFit& fit) {
    const Eigen::ArrayXd counts = countedOnes(fit);
    Eigen::ArrayXd strength = 1.0 + strengthErrors(turns, rangeOf(fit.ellipse)).array();
    strength = strength / ((counts * strength).sum() / std::max(1.0, counts.sum())) - 1.0;
    const std::optional<double> wobble = wobbleOf(turns, fit);
    double vertical = 0.0;
    for (const MagneticSample& sample : turns.samples) vertical += sample.field.z();
    vertical = std::abs(vertical) / static_cast<double>(turns.samples.size());
    return {.gaps = gapsOfCircle(fit),
            .variance = rmsOfCounted(strength, counts),
            .wobble = wobble,
            .tilt_error = wobble.value_or(0.0) * vertical / fit.radius(),
            .fit_error = rmsOfCounted(fit.distance.array(), counts) / fit.radius(),
            .outliers = 1.0 - counts.mean()};
}

FieldQuality fieldQualityOf(const EllipsoidFit& fit) {
    return {.gaps = fit.gaps,
            .variance = fit.variance,
            .fit_error = fit.fit_error,
            .outliers = fit.outliers};
}

}  // namespace hedr
