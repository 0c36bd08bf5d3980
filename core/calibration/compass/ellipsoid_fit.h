#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>

#include "core/calibration/estimate.h"

namespace hedr {

// What a field makes of the sphere while the sensor is turned through all directions: iron
// (field - centre) has the length `strength` in every direction.
struct Ellipsoid {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();    // hard iron, in the sensor's own unit
    Eigen::Matrix3d iron = Eigen::Matrix3d::Identity();  // undoes soft iron; symmetric, det 1
    double strength = 1.0;                               // in the sensor's own unit

    Eigen::Vector3d withoutIron(const Eigen::Vector3d& field) const {
        return iron * (field - centre);
    }
};

struct EllipsoidFit {
    Ellipsoid ellipsoid{};
    std::array<Estimate, 3> centre{};
    double noise = 0.0;      // standard deviation across it, outliers left out
    double gaps = 1.0;       // share of the sphere where no reading is
    double variance = 0.0;   // standard deviation of the length over its mean, outliers left out
    double fit_error = 0.0;  // root mean square distance over the strength, outliers left out
    double outliers = 0.0;   // share of the readings
};

// Least distances to first order (P. D. Sampson 1982) by Gauss and Newton with Tukey's biweight,
// from the algebraic least squares of a quadric. The noise is taken as the same on all axes, and
// its correlation in time goes into the errors. None: the readings are no ellipsoid.
std::optional<EllipsoidFit> fitEllipsoid(std::span<const Eigen::Vector3d> field);

// Smallest over largest standard deviation by direction: near 0 for turns in a plane, 1 for a whole
// sphere.
double roundness(std::span<const Eigen::Vector3d> field);

}  // namespace hedr
