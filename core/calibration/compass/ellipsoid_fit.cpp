#include "core/calibration/compass/ellipsoid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/calibration/compass/correlated_errors.h"
#include "core/calibration/median.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Readings3d = std::span<const Vector3d>;

constexpr std::size_t kFewestOfSphere = 60;
constexpr int kSphereSteps = 50;
constexpr double kSphereSettled = 1e-9;
constexpr double kSphereBiweight = 6.0;
constexpr double kSphereNormalPerMad = 1.4826;
constexpr Index kSphereParameters = 9;
constexpr std::size_t kBands = 6;   // of equal area
constexpr std::size_t kLunes = 12;  // sectors around the vertical axis

// |root (field - centre)| is 1 on it.
struct SphereRoot {
    Vector3d centre = Vector3d::Zero();
    Matrix3d root = Matrix3d::Identity();

    double strength() const { return 1.0 / std::cbrt(root.determinant()); }
};

struct SphereDistances {
    VectorXd distance{};
    MatrixXd outward{};  // by centre x, y, z, and root xx, yy, zz, xy, xz, yz
};

SphereDistances distancesFromSphere(const SphereRoot& sphere, Readings3d field) {
    const auto count = static_cast<Index>(field.size());
    SphereDistances result{VectorXd(count), MatrixXd(count, kSphereParameters)};
    for (Index i = 0; i < count; ++i) {
        const Vector3d off = field[static_cast<std::size_t>(i)] - sphere.centre;
        const Vector3d image = sphere.root * off;
        const double length = image.norm();
        const Vector3d unit = image / length;
        const Vector3d slope = sphere.root * unit;
        const double per_length = 1.0 / slope.norm();
        result.distance(i) = (length - 1.0) * per_length;
        const Matrix3d by_root = unit * off.transpose();
        result.outward.row(i) << slope.transpose() * per_length, -by_root(0, 0) * per_length,
            -by_root(1, 1) * per_length, -by_root(2, 2) * per_length,
            -(by_root(0, 1) + by_root(1, 0)) * per_length,
            -(by_root(0, 2) + by_root(2, 0)) * per_length,
            -(by_root(1, 2) + by_root(2, 1)) * per_length;
    }
    return result;
}

double sphereNoise(const VectorXd& distance) {
    std::vector<double> sizes(distance.data(), distance.data() + distance.size());
    for (double& size : sizes) size = std::abs(size);
    return kSphereNormalPerMad * medianOf(std::move(sizes));
}

VectorXd sphereWeights(const VectorXd& distance, double noise, double strength) {
    const double limit = kSphereBiweight * std::max(noise, 1e-6 * strength);
    return (1.0 - (distance / limit).array().square()).cwiseMax(0.0).square();
}

SphereRoot movedSphere(SphereRoot sphere, const VectorXd& step) {
    sphere.centre += step.head<3>();
    for (Index i = 0; i < 3; ++i) sphere.root(i, i) += step(3 + i);
    const std::pair<Index, Index> others[] = {{0, 1}, {0, 2}, {1, 2}};
    for (Index i = 0; i < 3; ++i) {
        const auto [row, column] = others[i];
        sphere.root(row, column) += step(6 + i);
        sphere.root(column, row) = sphere.root(row, column);
    }
    return sphere;
}

bool isSphereRoot(const SphereRoot& sphere) {
    if (!sphere.centre.allFinite() || !sphere.root.allFinite()) return false;
    return Eigen::LLT<Matrix3d>(sphere.root).info() == Eigen::Success;
}

// The quadric x² … = 1 about the middle of the least and the largest readings.
std::optional<SphereRoot> algebraicSphere(Readings3d field) {
    Vector3d least = field.front();
    Vector3d most = field.front();
    for (const Vector3d& reading : field) {
        least = least.cwiseMin(reading);
        most = most.cwiseMax(reading);
    }
    const Vector3d middle = 0.5 * (least + most);
    const double size = 0.5 * (most - least).maxCoeff();
    if (!(size > 0.0)) return std::nullopt;
    MatrixXd design(static_cast<Index>(field.size()), kSphereParameters);
    for (Index i = 0; i < design.rows(); ++i) {
        const Vector3d p = (field[static_cast<std::size_t>(i)] - middle) / size;
        design.row(i) << p.x() * p.x(), p.y() * p.y(), p.z() * p.z(), 2.0 * p.x() * p.y(),
            2.0 * p.x() * p.z(), 2.0 * p.y() * p.z(), 2.0 * p.x(), 2.0 * p.y(), 2.0 * p.z();
    }
    const VectorXd v = design.colPivHouseholderQr().solve(VectorXd::Ones(design.rows()));
    Matrix3d form;
    form << v(0), v(3), v(4), v(3), v(1), v(5), v(4), v(5), v(2);
    const Vector3d centre = -form.fullPivLu().solve(v.tail<3>());
    const double level = 1.0 + centre.dot(form * centre);
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(form / level);
    if (!centre.allFinite() || eigen.info() != Eigen::Success || eigen.eigenvalues()(0) <= 0.0)
        return std::nullopt;
    return SphereRoot{middle + size * centre, eigen.operatorSqrt() / size};
}

std::optional<SphereRoot> settledSphere(Readings3d field, SphereRoot sphere) {
    for (int step = 0; step < kSphereSteps; ++step) {
        const SphereDistances distances = distancesFromSphere(sphere, field);
        const double strength = sphere.strength();
        const VectorXd weight =
            sphereWeights(distances.distance, sphereNoise(distances.distance), strength);
        // In units of the strength, so that all columns are of one size.
        VectorXd scale = VectorXd::Constant(kSphereParameters, 1.0 / strength);
        scale.head<3>().setConstant(strength);
        const MatrixXd outward = distances.outward * scale.asDiagonal();
        const MatrixXd normal = outward.transpose() * weight.asDiagonal() * outward;
        const VectorXd change =
            normal.ldlt().solve(outward.transpose() * weight.cwiseProduct(distances.distance));
        sphere = movedSphere(sphere, scale.cwiseProduct(change));
        if (!isSphereRoot(sphere)) return std::nullopt;
        if (change.norm() < kSphereSettled) return sphere;
    }
    return std::nullopt;
}

double gapsOfSphere(const Ellipsoid& ellipsoid, Readings3d field) {
    std::vector<bool> seen(kBands * kLunes, false);
    for (const Vector3d& reading : field) {
        const Vector3d unit = ellipsoid.withoutIron(reading).normalized();
        const double height = 0.5 * (unit.z() + 1.0) * static_cast<double>(kBands);
        const double around =
            (std::atan2(unit.y(), unit.x()) / (2.0 * kPi) + 0.5) * static_cast<double>(kLunes);
        const std::size_t band = std::min(kBands - 1, static_cast<std::size_t>(height));
        const std::size_t lune = std::min(kLunes - 1, static_cast<std::size_t>(around));
        seen[band * kLunes + lune] = true;
    }
    const auto missing = std::count(seen.begin(), seen.end(), false);
    return static_cast<double>(missing) / static_cast<double>(seen.size());
}

void findSphereErrors(EllipsoidFit& fit, const SphereRoot& sphere, Readings3d field) {
    const SphereDistances distances = distancesFromSphere(sphere, field);
    const VectorXd& distance = distances.distance;
    fit.noise = sphereNoise(distance);
    const VectorXd weight = sphereWeights(distance, fit.noise, fit.ellipsoid.strength);
    const std::vector<std::size_t> begins{0};
    const ErrorCorrelation correlation =
        correlationOf(weight.cwiseProduct(distance), distances.outward, begins);
    const double limit = kSphereBiweight * std::max(fit.noise, 1e-6 * fit.ellipsoid.strength);
    const Eigen::ArrayXd squares = (distance / limit).array().square();
    // Of distance times weight.
    const VectorXd slope =
        (squares < 1.0).select((1.0 - squares) * (1.0 - 5.0 * squares), 0.0).matrix();
    const MatrixXd inverse =
        (distances.outward.transpose() * slope.asDiagonal() * distances.outward)
            .ldlt()
            .solve(MatrixXd::Identity(kSphereParameters, kSphereParameters));
    const MatrixXd errors =
        inverse * scoreCovariance(distances.outward, correlation, begins) * inverse;
    const double degrees =
        std::max(1.0, correlation.degrees_of_freedom - static_cast<double>(kSphereParameters));
    for (Index axis = 0; axis < 3; ++axis) {
        fit.centre[static_cast<std::size_t>(axis)] = {
            sphere.centre(axis), std::sqrt(std::max(0.0, errors(axis, axis))), degrees};
    }
    const Eigen::ArrayXd counts = (weight.array() > 0.0).cast<double>();
    const double counted = std::max(1.0, counts.sum());
    fit.outliers = 1.0 - counts.mean();
    fit.fit_error =
        std::sqrt((counts * distance.array().square()).sum() / counted) / fit.ellipsoid.strength;
    Eigen::ArrayXd lengths(weight.size());
    for (Index i = 0; i < lengths.size(); ++i) {
        lengths(i) = fit.ellipsoid.withoutIron(field[static_cast<std::size_t>(i)]).norm();
    }
    const double mean = (counts * lengths).sum() / counted;
    fit.variance = std::sqrt((counts * (lengths - mean).square()).sum() / counted) / mean;
}

}  // namespace

std::optional<EllipsoidFit> fitEllipsoid(Readings3d field) {
    if (field.size() < kFewestOfSphere) return std::nullopt;
    const auto start = algebraicSphere(field);
    if (!start) return std::nullopt;
    const auto sphere = settledSphere(field, *start);
    if (!sphere) return std::nullopt;
    EllipsoidFit fit;
    fit.ellipsoid = {sphere->centre, sphere->root * sphere->strength(), sphere->strength()};
    fit.gaps = gapsOfSphere(fit.ellipsoid, field);
    findSphereErrors(fit, *sphere, field);
    return fit;
}

double roundness(Readings3d field) {
    if (field.empty()) return 0.0;
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& reading : field) mean += reading / static_cast<double>(field.size());
    Matrix3d spread = Matrix3d::Zero();
    for (const Vector3d& reading : field) spread += (reading - mean) * (reading - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(spread, Eigen::EigenvaluesOnly);
    const double largest = eigen.eigenvalues()(2);
    return largest > 0.0 ? std::sqrt(std::max(0.0, eigen.eigenvalues()(0)) / largest) : 0.0;
}

}  // namespace hedr
