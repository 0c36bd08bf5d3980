#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "core/geometry/frames.h"
#include "core/site/survey/quad.h"

namespace hedr {

// A plane seen from elsewhere: to_from * Point<From> is a Point<To>. Points of negative depth lie
// behind the viewer; those of depth 0 have no image.
template <class To, class From>
class Perspective {
  public:
    Perspective() = default;
    explicit Perspective(const Eigen::Matrix3d& matrix) : matrix_(matrix) {}

    Point<To> operator*(Point<From> p) const {
        const Eigen::Vector3d image = matrix_ * Eigen::Vector3d(p.x, p.y, 1.0);
        return {image.x() / image.z(), image.y() / image.z()};
    }
    template <class Inner>
    Perspective<To, Inner> operator*(const Perspective<From, Inner>& inner) const {
        return Perspective<To, Inner>(matrix_ * inner.matrix());
    }
    Perspective<From, To> inverse() const { return Perspective<From, To>(matrix_.inverse()); }
    double depth(Point<From> p) const {
        return matrix_.row(2).dot(Eigen::RowVector3d(p.x, p.y, 1));
    }

    const Eigen::Matrix3d& matrix() const { return matrix_; }

  private:
    Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Identity();
};

struct UnitSquare {};  // (0, 0) the rectangle's upper left corner, (1, 1) its lower right one

// Of a convex quad; the depth is positive in the whole square.
Perspective<Plan, UnitSquare> photoFromUnitSquare(const Quad& quad);

}  // namespace hedr
