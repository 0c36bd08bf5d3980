#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/robot/vehicle.h"

namespace hedr {

// The point at the angle φ is centre + shape (cos φ, sin φ), in the sensor's own unit.
struct Ellipse {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Matrix2d shape = Eigen::Matrix2d::Identity();  // lower triangular, diagonal positive

    Eigen::Vector2d at(double angle_rad) const;
    double angleOf(const Eigen::Vector2d& field) const;  // of the field without iron
    bool isUsable() const;                               // finite and not as flat as a line
    double radius() const;                               // geometric mean of the half axes
};

// Both ranges positive. Together they are one-to-one.
MagnetometerRange rangeOf(const Ellipse& ellipse);
Ellipse ellipseFrom(const MagnetometerRange& range);  // signs of the ranges are lost

// An ellipse through all readings but those far outside of most of them: R. Halir, J. Flusser,
// "Numerically stable direct least squares fitting of ellipses", WSCG 1998. It has a bias where
// there is noise: a start for fitEllipse. None: they lie on a line or in one place.
std::optional<Ellipse> directEllipse(std::span<const Eigen::Vector2d> field);

}  // namespace hedr
