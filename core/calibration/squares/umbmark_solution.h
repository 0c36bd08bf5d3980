#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/squares/square_runs.h"
#include "core/calibration/squares/umbmark_ends.h"
#include "core/robot/vehicle.h"

namespace hedr {

// A square drive and where it ended. Whoever made the runs keeps them.
struct MeasuredSquare {
    const SquareRun* run = nullptr;
    UmbmarkEnd end{};
};

// E_d, the right wheel's diameter over the left one's, and E_b, the wheelbase: real over believed.
using UmbmarkRatios = Eigen::Vector2d;

// What one square says of the ratios, around some.
struct EndEquation {
    Eigen::Vector2d error_m = Eigen::Vector2d::Zero();     // true minus computed end
    Eigen::Matrix2d jacobian_m = Eigen::Matrix2d::Zero();  // of the computed end

    Vector<Robot> way() const { return {error_m.x(), error_m.y()}; }
};

// The drive integrated again, from its encoders, with corrected wheels.
EndEquation endEquation(const MeasuredSquare& square, const VehicleGeometry& believed,
                        const UmbmarkRatios& ratios);

struct UmbmarkSolution {
    UmbmarkRatios ratios = UmbmarkRatios::Ones();
    std::vector<EndEquation> equations{};  // around them, one for each square
};

// The ratios that fit all ends best, by least squares (Levenberg-Marquardt). `near`: where to
// begin, if that is known. Ends must be finite.
UmbmarkSolution solveUmbmark(std::span<const MeasuredSquare> squares,
                             const VehicleGeometry& believed,
                             const std::optional<UmbmarkRatios>& near = {});

}  // namespace hedr
