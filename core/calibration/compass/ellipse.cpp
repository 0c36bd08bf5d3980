#include "core/calibration/compass/ellipse.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/calibration/median.h"

namespace hedr {

namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kFewestOfEllipse = 20;

// The readings within a few times the usual distance from the middle one, by each axis.
std::vector<Vector2d> withoutFarOnes(std::span<const Vector2d> field) {
    constexpr double kFar = 6.0;
    std::vector<double> values[2];
    for (const Vector2d& reading : field) {
        values[0].push_back(reading.x());
        values[1].push_back(reading.y());
    }
    Vector2d middle;
    Vector2d usual;
    for (Index axis = 0; axis < 2; ++axis) {
        middle(axis) = medianOf(values[axis]);
        for (double& value : values[axis]) value = std::abs(value - middle(axis));
        usual(axis) = medianOf(values[axis]);
    }
    std::vector<Vector2d> near;
    near.reserve(field.size());
    for (const Vector2d& reading : field) {
        const Vector2d off = (reading - middle).cwiseAbs();
        if (off.x() <= kFar * usual.x() && off.y() <= kFar * usual.y()) near.push_back(reading);
    }
    return near;
}

// Of a x² + b x y + c y² + d x + e y + f = 0.
std::optional<Ellipse> ellipseOfConic(const Vector3d& square, const Vector3d& linear) {
    Matrix2d form;
    form << square(0), 0.5 * square(1), 0.5 * square(1), square(2);
    if (form.trace() < 0.0) return ellipseOfConic(-square, -linear);
    if (!(form.determinant() > 0.0)) return std::nullopt;
    Ellipse ellipse;
    ellipse.centre = -0.5 * form.inverse() * linear.head<2>();
    const double level = ellipse.centre.dot(form * ellipse.centre) - linear(2);
    if (!(level > 0.0)) return std::nullopt;
    const Eigen::LLT<Matrix2d> root(level * form.inverse());
    if (root.info() != Eigen::Success) return std::nullopt;
    ellipse.shape = root.matrixL();
    return ellipse;
}

// Of readings about zero and of size one: the smallest of (D v)² with 4 a c - b² = 1.
std::optional<Ellipse> directEllipseOfSizeOne(std::span<const Vector2d> field) {
    Matrix3d squares = Matrix3d::Zero();
    Matrix3d mixed = Matrix3d::Zero();
    Matrix3d linears = Matrix3d::Zero();
    for (const Vector2d& p : field) {
        const Vector3d square(p.x() * p.x(), p.x() * p.y(), p.y() * p.y());
        const Vector3d linear(p.x(), p.y(), 1.0);
        squares += square * square.transpose();
        mixed += square * linear.transpose();
        linears += linear * linear.transpose();
    }
    const Eigen::FullPivLU<Matrix3d> solver(linears);
    if (!solver.isInvertible()) return std::nullopt;
    const Matrix3d linear_of_square = -solver.solve(mixed.transpose());
    const Matrix3d reduced = squares + mixed * linear_of_square;
    Matrix3d scaled;
    scaled << 0.5 * reduced.row(2), -reduced.row(1), 0.5 * reduced.row(0);
    const Eigen::EigenSolver<Matrix3d> eigen(scaled);
    if (eigen.info() != Eigen::Success) return std::nullopt;
    for (Index i = 0; i < 3; ++i) {
        const Vector3d square = eigen.eigenvectors().col(i).real();
        if (4.0 * square(0) * square(2) - square(1) * square(1) <= 0.0) continue;
        return ellipseOfConic(square, linear_of_square * square);
    }
    return std::nullopt;
}

}  // namespace

bool Ellipse::isUsable() const {
    constexpr double kFlattest = 1e-3;
    return centre.allFinite() && shape.allFinite() && shape(0, 0) > 0.0 &&
           shape(1, 1) > kFlattest * std::abs(shape(1, 0)) &&
           shape(1, 1) > kFlattest * shape(0, 0) && shape(0, 0) > kFlattest * shape(1, 1);
}

Vector2d Ellipse::at(double angle_rad) const {
    return centre + shape * Vector2d(std::cos(angle_rad), std::sin(angle_rad));
}

double Ellipse::angleOf(const Vector2d& field) const {
    const Vector2d unit = shape.triangularView<Eigen::Lower>().solve(field - centre);
    return std::atan2(unit.y(), unit.x());
}

double Ellipse::radius() const { return std::sqrt(shape.determinant()); }

MagnetometerRange rangeOf(const Ellipse& ellipse) {
    const double range_y = std::hypot(ellipse.shape(1, 0), ellipse.shape(1, 1));
    return {ellipse.centre.x(), ellipse.centre.y(), ellipse.shape(0, 0), range_y,
            ellipse.shape(1, 0) / range_y};
}

Ellipse ellipseFrom(const MagnetometerRange& range) {
    const double sign = range.range_x * range.range_y < 0.0 ? -1.0 : 1.0;
    const double range_y = std::abs(range.range_y);
    Ellipse ellipse;
    ellipse.centre = {range.centre_x, range.centre_y};
    ellipse.shape << std::abs(range.range_x), 0.0, sign * range.correlation * range_y,
        range_y * std::sqrt(1.0 - range.correlation * range.correlation);
    return ellipse;
}

std::optional<Ellipse> directEllipse(std::span<const Vector2d> field) {
    if (field.size() < kFewestOfEllipse) return std::nullopt;
    std::vector<Vector2d> near = withoutFarOnes(field);
    if (near.size() < kFewestOfEllipse) return std::nullopt;
    Vector2d mean = Vector2d::Zero();
    for (const Vector2d& reading : near) mean += reading / static_cast<double>(near.size());
    double size = 0.0;
    for (const Vector2d& reading : near) size = std::max(size, (reading - mean).norm());
    if (!(size > 0.0)) return std::nullopt;
    for (Vector2d& reading : near) reading = (reading - mean) / size;
    auto ellipse = directEllipseOfSizeOne(near);
    if (!ellipse) return std::nullopt;
    ellipse->centre = mean + size * ellipse->centre;
    ellipse->shape *= size;
    return ellipse->isUsable() ? ellipse : std::nullopt;
}

}  // namespace hedr
