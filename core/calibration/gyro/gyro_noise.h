#pragma once

#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/gyro/gyro_noise_fit.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct GyroNoiseResult {
    std::vector<AllanPoint> deviations{};
    std::optional<GyroNoiseFit> fit{};
    Calibration calibration{};
};

// How noisy a gyro is, from a robot that stands: "gyro_noise_rad_s_sqrthz" and, where the record
// is long enough to tell it, "gyro_bias_walk_rad_s_sqrts" of the vehicle file. Refused, with the
// reason, are records that are too short, hold values that are no numbers, or in which the robot
// moves.
GyroNoiseResult calibrateGyroNoise(std::span<const SensorReport> reports, const Vehicle& believed);

}  // namespace hedr
