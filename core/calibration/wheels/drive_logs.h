#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/encoders/encoder_travel.h"
#include "core/calibration/sample_set.h"
#include "core/calibration/wheels/drive_rows.h"
#include "core/robot/vehicle.h"

namespace hedr {

// Drives as wheels and gyro tell them.
struct DriveReadings {
    std::vector<DriveLog> logs{};  // those that have both
    bool has_encoders = false;
    bool has_sides = false;
    bool has_gyro = false;
    bool beyond_range = false;  // of the gyro
    std::size_t readings = 0;
    std::size_t broken = 0;
    double rolled_m = 0.0;
    double straight_m = 0.0;  // of it, not in turns
    double left_rad = 0.0;    // turned that way in turns
    double right_rad = 0.0;
    double stood_s = 0.0;
    double moved_s = 0.0;
};

DriveReadings readDrives(std::span<const SampleSet> sets, const Vehicle& vehicle);

}  // namespace hedr
