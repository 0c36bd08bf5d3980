#pragma once

#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/sample_set.h"
#include "core/calibration/wheels/drive_fit.h"
#include "core/calibration/wheels/drive_logs.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct WheelDriveOptions {
    double wanted_wheelbase_share = 0.015;  // standard error, as a share of it
    double wanted_right_larger = 0.0015;    // standard error; about half an hour where tracks slip
    double unsure_gyro_scale = 0.03;        // of a gyro whose scale was never calibrated
};

struct WheelDrive {
    DriveReadings drives{};
    DriveFit fit{};
    Calibration calibration{};
};

// Effective wheelbase and ratio of the wheels, "wheelbase_m", "left_wheel_diameter_m" and
// "right_wheel_diameter_m" of the vehicle file (the mean of the two stays), from ordinary drives of
// a robot with a gyro. What is not surely nearer to the truth than the old value stays; so does a
// wheelbase no further off than the gyro's scale may be, unless that was calibrated.
// Refused, with the reason, are drives without a gyro or encoders of both sides, readings that are
// no numbers, a gyro at the end of its range, drives too short or without turns, wheels that turn
// the other way round than the gyro, and wheels that are not nearly alike.
WheelDrive calibrateByDriving(std::span<const SampleSet> sets, const Vehicle& believed,
                              const WheelDriveOptions& options = {});

}  // namespace hedr
