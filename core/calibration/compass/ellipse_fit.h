#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/compass/correlated_errors.h"
#include "core/calibration/compass/ellipse.h"

namespace hedr {

using EllipseMatrix = Eigen::Matrix<double, 5, 5>;

struct EllipseFit {
    Ellipse ellipse{};
    EllipseMatrix covariance = EllipseMatrix::Zero();  // of the numbers of rangeOf, in its order
    double degrees_of_freedom = 0.0;
    double noise = 0.0;           // standard deviation across the ellipse, outliers left out
    Eigen::VectorXd distance{};   // of each reading from the ellipse, outward
    Eigen::VectorXd angle_rad{};  // of its foot on the ellipse
    Eigen::VectorXd weight{};     // 0: an outlier
    ErrorCorrelation correlation{};

    double radius() const { return ellipse.radius(); }
};

struct FieldReadings {
    std::vector<Eigen::Vector2d> field{};  // x, y
    std::vector<std::size_t> begins{};     // of stretches that follow one another in time
};

// The ellipse of least distances (maximum likelihood where the noise is the same in x and y), with
// Tukey's biweight, from a start; none: it does not settle. Noise along an ellipse takes a reading
// outward by curvature * variance / 2 (K. Kanatani, "Ellipse fitting with hyperaccuracy", 2006);
// that is taken off, so that the estimate has no bias of that order.
// The heading of a gyro would make the centre's error smaller by √2, but a gyro's scale, bias and
// delay would go into it, and it could no longer judge the result.
std::optional<Ellipse> settledEllipse(std::span<const Eigen::Vector2d> field, const Ellipse& start);

// The same with the errors, for which the correlation of the noise is looked at.
std::optional<EllipseFit> fitEllipse(const FieldReadings& readings);

}  // namespace hedr
