#include "core/site/survey/sheet_aspect.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/site/survey/perspective.h"

namespace hedr {
namespace {

// What is not known exactly: the corners, the principal point, the logarithm of the focal length.
// Lengths are in diagonals of the photo, from its middle.
constexpr int kUnknowns = 11;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Row = Eigen::Matrix<double, 1, kUnknowns>;
constexpr int kPrincipal = 8;
constexpr int kLogFocal = 10;

// A phone's main camera is like a lens of 27 mm on film of 24 x 36 mm.
constexpr double kPhoneFocal = 27.0 / 43.27;
constexpr double kSigmaCorner = 0.0007;
constexpr double kSigmaPrincipal = 0.004;
constexpr double kSigmaPhoneFocal = 0.1;
constexpr int kRounds = 12;
constexpr double kStep = 1e-6;

// The rectangle's sides as vectors in the camera's frame, to a common scale.
struct Sides {
    Eigen::Vector3d across;
    Eigen::Vector3d down;
};

Sides sidesOf(const Unknowns& x) {
    Quad quad;
    for (Eigen::Index i = 0; i < 4; ++i) {
        quad.corners[static_cast<std::size_t>(i)] = {x[2 * i] - x[kPrincipal],
                                                     x[2 * i + 1] - x[kPrincipal + 1]};
    }
    const Eigen::Matrix3d matrix = photoFromUnitSquare(quad).matrix();
    const double focal = std::exp(x[kLogFocal]);
    const Eigen::Vector3d ray(1.0 / focal, 1.0 / focal, 1.0);
    return {matrix.col(0).cwiseProduct(ray), matrix.col(1).cwiseProduct(ray)};
}

double cosineOfSides(const Unknowns& x) {
    const Sides sides = sidesOf(x);
    return sides.across.normalized().dot(sides.down.normalized());
}

double logAspect(const Unknowns& x) {
    const Sides sides = sidesOf(x);
    return std::log(sides.across.norm() / sides.down.norm());
}

template <class Function>
Row gradient(const Function& function, const Unknowns& x) {
    Row slope;
    for (int i = 0; i < kUnknowns; ++i) {
        const Unknowns step = kStep * Unknowns::Unit(i);
        slope[i] = (function(x + step) - function(x - step)) / (2.0 * kStep);
    }
    return slope;
}

Unknowns asSeen(const Quad& quad, int width_px, int height_px) {
    const double diagonal_px = std::hypot(width_px, height_px);
    Unknowns x = Unknowns::Zero();
    for (Eigen::Index i = 0; i < 4; ++i) {
        const Point<Plan> corner = quad.corners[static_cast<std::size_t>(i)];
        x[2 * i] = (corner.x - 0.5 * width_px) / diagonal_px;
        x[2 * i + 1] = (corner.y - 0.5 * height_px) / diagonal_px;
    }
    return x;
}

// In diagonals of the photo.
FocalLength focalLengthBefore(const std::optional<FocalLength>& told, int width_px, int height_px) {
    if (!told) return {kPhoneFocal, kSigmaPhoneFocal};
    return {told->px / std::hypot(width_px, height_px), told->sigma};
}

}  // namespace

SheetAspect sheetAspect(const Quad& quad, int photo_width_px, int photo_height_px,
                        const std::optional<FocalLength>& focal_length) {
    const FocalLength focal = focalLengthBefore(focal_length, photo_width_px, photo_height_px);
    Unknowns prior = asSeen(quad, photo_width_px, photo_height_px);
    prior[kLogFocal] = std::log(focal.px);
    Unknowns variance = Unknowns::Constant(kSigmaCorner * kSigmaCorner);
    variance.segment<2>(kPrincipal).setConstant(kSigmaPrincipal * kSigmaPrincipal);
    variance[kLogFocal] = focal.sigma * focal.sigma;

    // An iterated Kalman update with one exact measurement: the sides are at right angles.
    Unknowns x = prior;
    Unknowns gain = Unknowns::Zero();
    Row slope = Row::Zero();
    for (int round = 0; round < kRounds; ++round) {
        slope = gradient(cosineOfSides, x);
        const Unknowns spread = variance.cwiseProduct(slope.transpose());
        gain = spread / std::max(slope.dot(spread), 1e-30);
        x = prior - gain * (cosineOfSides(x) + slope.dot(prior - x));
    }
    const Row aspect_slope = gradient(logAspect, x);
    const Row blind = aspect_slope - aspect_slope.dot(gain) * slope;
    return {std::exp(logAspect(x)), std::sqrt(blind.cwiseAbs2().dot(variance))};
}

}  // namespace hedr
