#include "core/calibration/compass/ellipse_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/calibration/median.h"
#include "core/geometry/angle.h"

namespace hedr {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using EllipseJacobian = Eigen::Matrix<double, Eigen::Dynamic, 5>;

constexpr int kMostSteps = 40;
constexpr double kSettled = 1e-8;  // step over radius
constexpr double kBiweight = 6.0;  // times the noise; efficiency 98 % where there is no outlier
constexpr double kNormalPerMad = 1.4826;

// Distances from an ellipse and how its numbers (centre x, y, shape xx, yx, yy) move its outline.
struct EllipseDistances {
    VectorXd distance{};
    VectorXd angle_rad{};
    VectorXd curvature{};
    EllipseJacobian outward{};
};

// The angle of the nearest point, by Newton's method.
double footOf(const Ellipse& ellipse, const Vector2d& field) {
    constexpr int kSteps = 5;
    double angle_rad = ellipse.angleOf(field);
    for (int step = 0; step < kSteps; ++step) {
        const Vector2d radial = ellipse.at(angle_rad) - ellipse.centre;
        const Vector2d along = ellipse.shape * Vector2d(-std::sin(angle_rad), std::cos(angle_rad));
        const Vector2d off = field - ellipse.centre - radial;
        const double slope = along.squaredNorm() + off.dot(radial);
        if (!(slope > 0.0)) break;
        const double change_rad = off.dot(along) / slope;
        angle_rad += change_rad;
        if (std::abs(change_rad) < kSettled) break;
    }
    return angle_rad;
}

EllipseDistances distancesFrom(const Ellipse& ellipse, std::span<const Vector2d> field) {
    const auto count = static_cast<Index>(field.size());
    EllipseDistances result{VectorXd(count), VectorXd(count), VectorXd(count),
                            EllipseJacobian(count, 5)};
    for (Index i = 0; i < count; ++i) {
        const Vector2d& reading = field[static_cast<std::size_t>(i)];
        const double angle_rad = footOf(ellipse, reading);
        const Vector2d unit(std::cos(angle_rad), std::sin(angle_rad));
        const Vector2d along = ellipse.shape * Vector2d(-unit.y(), unit.x());
        const double speed = along.norm();
        const Vector2d normal(along.y() / speed, -along.x() / speed);
        result.angle_rad(i) = angle_rad;
        result.distance(i) = normal.dot(reading - ellipse.at(angle_rad));
        result.curvature(i) = ellipse.shape.determinant() / (speed * speed * speed);
        result.outward.row(i) << normal.x(), normal.y(), normal.x() * unit.x(),
            normal.y() * unit.x(), normal.y() * unit.y();
    }
    return result;
}

double robustNoise(const VectorXd& distance) {
    std::vector<double> sizes(distance.data(), distance.data() + distance.size());
    for (double& size : sizes) size = std::abs(size);
    return kNormalPerMad * medianOf(std::move(sizes));
}

VectorXd withoutNoiseAlong(const EllipseDistances& distances, double noise) {
    return distances.distance - 0.5 * noise * noise * distances.curvature;
}

// Without any noise all count.
VectorXd biweights(const VectorXd& distance, double noise, double radius) {
    const double limit = kBiweight * std::max(noise, 1e-6 * radius);
    return (1.0 - (distance / limit).array().square()).cwiseMax(0.0).square();
}

// Of distance times weight.
VectorXd slopesOfInfluence(const VectorXd& distance, double noise, double radius) {
    const double limit = kBiweight * std::max(noise, 1e-6 * radius);
    const Eigen::ArrayXd squares = (distance / limit).array().square();
    return (squares < 1.0).select((1.0 - squares) * (1.0 - 5.0 * squares), 0.0);
}

Ellipse moved(const Ellipse& ellipse, const VectorXd& step) {
    Ellipse result = ellipse;
    result.centre += step.head<2>();
    result.shape(0, 0) += step(2);
    result.shape(1, 0) += step(3);
    result.shape(1, 1) += step(4);
    return result;
}

// The step of a sensor's readings.
double roundingStep(std::span<const Vector2d> field, Index axis) {
    std::vector<double> values;
    values.reserve(field.size());
    for (const Vector2d& reading : field) values.push_back(reading(axis));
    std::sort(values.begin(), values.end());
    double step = values.back() - values.front();
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double apart = values[i] - values[i - 1];
        if (apart > 0.0) step = std::min(step, apart);
    }
    return step;
}

// Readings at one place of the ellipse are rounded alike in every turn, so no number of turns takes
// that error away. Where the noise is s and the step q, it is the sum over k of
// q / (pi k) exp(-2 (pi k s / q)²) sin(2 pi k (x - x0) / q), x0 anywhere (B. Widrow, I. Kollár,
// "Quantization Noise", 2008, chapter 4).
EllipseMatrix scoresOfRounding(const EllipseFit& fit, const EllipseDistances& distances,
                               std::span<const Vector2d> field) {
    constexpr int kWaves = 3;
    EllipseMatrix scores = EllipseMatrix::Zero();
    for (Index axis = 0; axis < 2; ++axis) {
        const double step = roundingStep(field, axis);
        const double noise = std::sqrt(std::max(0.0, fit.noise * fit.noise - step * step / 12.0));
        for (int wave = 1; wave <= kWaves; ++wave) {
            const double per_step = kPi * wave / step;
            const double size =
                std::exp(-2.0 * std::pow(per_step * noise, 2)) / (kPi * wave) * step;
            Eigen::Matrix<double, 5, 2> sums = Eigen::Matrix<double, 5, 2>::Zero();
            for (Index i = 0; i < fit.angle_rad.size(); ++i) {
                const double at_rad = 2.0 * per_step * fit.ellipse.at(fit.angle_rad(i))(axis);
                const double across = distances.outward(i, axis) * fit.weight(i);
                sums += across * distances.outward.row(i).transpose() *
                        Eigen::RowVector2d(std::cos(at_rad), std::sin(at_rad));
            }
            scores += 0.5 * size * size * sums * sums.transpose();
        }
    }
    return scores;
}

// d(range)/d(centre, shape).
EllipseMatrix rangeSlopes(const Ellipse& ellipse) {
    const double yx = ellipse.shape(1, 0);
    const double yy = ellipse.shape(1, 1);
    const double range_y = std::hypot(yx, yy);
    const double cube = range_y * range_y * range_y;
    EllipseMatrix slopes = EllipseMatrix::Zero();
    slopes(0, 0) = slopes(1, 1) = slopes(2, 2) = 1.0;
    slopes(3, 3) = yx / range_y;
    slopes(3, 4) = yy / range_y;
    slopes(4, 3) = yy * yy / cube;
    slopes(4, 4) = -yx * yy / cube;
    return slopes;
}

void findErrors(EllipseFit& fit, const EllipseDistances& distances, const FieldReadings& readings) {
    const std::vector<std::size_t>& begins = readings.begins;
    const VectorXd slopes = slopesOfInfluence(fit.distance, fit.noise, fit.radius());
    fit.correlation =
        correlationOf(fit.weight.cwiseProduct(fit.distance), distances.outward, begins);
    const EllipseMatrix inverse =
        (distances.outward.transpose() * slopes.asDiagonal() * distances.outward).inverse();
    const EllipseMatrix scores = scoreCovariance(distances.outward, fit.correlation, begins) +
                                 scoresOfRounding(fit, distances, readings.field);
    const EllipseMatrix to_range = rangeSlopes(fit.ellipse) * inverse;
    fit.covariance = to_range * scores * to_range.transpose();
    fit.degrees_of_freedom = std::max(1.0, fit.correlation.degrees_of_freedom);
}

}  // namespace

std::optional<Ellipse> settledEllipse(std::span<const Vector2d> field, const Ellipse& start) {
    constexpr std::size_t kFewest = 20;
    if (field.size() < kFewest) return std::nullopt;
    Ellipse ellipse = start;
    for (int step = 0; step < kMostSteps; ++step) {
        const EllipseDistances distances = distancesFrom(ellipse, field);
        const double noise = robustNoise(distances.distance);
        const VectorXd off = withoutNoiseAlong(distances, noise);
        const VectorXd weight = biweights(off, noise, ellipse.radius());
        const EllipseMatrix normal =
            distances.outward.transpose() * weight.asDiagonal() * distances.outward;
        const Eigen::LDLT<EllipseMatrix> solver(normal);
        const VectorXd change =
            solver.solve(distances.outward.transpose() * weight.cwiseProduct(off));
        const Ellipse next = moved(ellipse, change);
        if (!next.isUsable()) return std::nullopt;
        ellipse = next;
        if (change.norm() < kSettled * ellipse.radius()) return ellipse;
    }
    return std::nullopt;
}

std::optional<EllipseFit> fitEllipse(const FieldReadings& readings) {
    const auto start = directEllipse(readings.field);
    if (!start) return std::nullopt;
    const auto ellipse = settledEllipse(readings.field, *start);
    if (!ellipse) return std::nullopt;
    EllipseFit fit{.ellipse = *ellipse};
    const EllipseDistances distances = distancesFrom(*ellipse, readings.field);
    fit.noise = robustNoise(distances.distance);
    fit.distance = withoutNoiseAlong(distances, fit.noise);
    fit.angle_rad = distances.angle_rad;
    fit.weight = biweights(fit.distance, fit.noise, fit.radius());
    findErrors(fit, distances, readings);
    return fit;
}

}  // namespace hedr
