#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/proof.h"
#include "core/calibration/wheels/drive_rows.h"

namespace hedr {

struct DriveFitOptions {
    double believed_wheelbase_m = 0.0;
    // By how much of itself the wheelbase may come out wrong because the gyro's scale is.
    double unsure_share = 0.0;
};

struct DriveFit {
    Estimate wheelbase_m{};
    Estimate right_larger{};         // as in WheelShape
    bool wheelbase_changes = false;  // surely (99.9 %) nearer to the truth than what was believed
    bool right_larger_changes = false;
    bool gyro_scale_may_explain = false;  // only that keeps the wheelbase from changing
    double slip_m_sqrtm = 0.0;     // what the sides slip against each other on one metre of way
    double turn_slip_share = 0.0;  // how much the wheelbase differs from turn to turn, rms
    std::size_t parts = 0;         // of the drive, that standard errors and proof are made of
    // Per piece, log by log: what the robot turned by the gyro less its bias, and how much the
    // piece counts, from 0 (a wheel slipped) to 1.
    std::vector<double> turned_rad{};
    std::vector<double> weights{};
    // Per part: what the wheels miss of the heading in it, along the way and in turns, by the
    // believed wheels and by those that the other parts give, as far as they change. Both where
    // neither does.
    std::vector<HeldOutError> held_out{};
};

inline constexpr std::size_t kFewestDriveParts = 6;

// Wheelbase and ratio of the wheels from any drive with a gyro: the model of DriveRows by
// generalised least squares, with Tukey's biweight for pieces in which a wheel slips. The variance
// grows with the way and with the square of the turn; how much is found from the residuals.
// Standard errors are a jackknife over parts of the drive, each with as much way and turning as
// the others, so that it does not matter what slip is like within them. No fit (parts = 0) where
// there are fewer turns, or fewer other pieces, than kFewestDriveParts.
DriveFit fitDrive(std::span<const DriveLog> logs, const DriveFitOptions& options);

}  // namespace hedr
