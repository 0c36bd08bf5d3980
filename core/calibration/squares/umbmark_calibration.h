#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/sample_set.h"
#include "core/calibration/squares/square_runs.h"
#include "core/calibration/squares/umbmark.h"
#include "core/calibration/squares/umbmark_ends.h"
#include "core/calibration/squares/umbmark_scatter.h"
#include "core/robot/vehicle.h"

namespace hedr {

// A square with its end: true minus computed, in the axes of its start.
struct UmbmarkSquare {
    std::size_t number = 0;
    Turning turning = Turning::kClockwise;
    Vector<Robot> before{};             // with the believed wheels
    Vector<Robot> after{};              // with wheels found without this square
    std::optional<double> far_off_m{};  // so far from the others: not counted
};

struct UmbmarkCalibration {
    SquareRuns drives{};
    std::vector<UmbmarkSquare> squares{};  // that have an end
    UmbmarkEstimates ratios{};             // E_d and E_b, by least squares on all ends
    Eigen::Vector2d metres_per_ratio = Eigen::Vector2d::Zero();
    bool directions_agree = true;
    std::optional<UmbmarkFit> closed_form{};  // the paper's; none: errors are too large for it
    double side_m = 0.0;                      // by the encoders
    double largest_before_m = 0.0;            // E_max,syst
    double largest_after_m = 0.0;             // the same of held-out squares
    Calibration calibration{};
};

// "wheelbase_m" and the ratio of "left_wheel_diameter_m" to "right_wheel_diameter_m", whose mean
// stays, from squares driven both ways: least squares on all ends, every drive integrated again
// from its encoders. Squares that ended far from the others do not count; all that does not is
// named in the remarks. Differs from the paper: the robot need not drive by its own odometry.
UmbmarkCalibration calibrateUmbmark(std::span<const SampleSet> sets,
                                    std::span<const UmbmarkEnd> ends, const Vehicle& believed);

}  // namespace hedr
