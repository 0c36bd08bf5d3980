#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// By what the heading is known that a magnetometer is judged by.
enum class HeadingJudge : unsigned char { kNone, kGyro, kEncoders };

struct MagneticSample {
    double t_s = 0.0;
    Eigen::Vector3d field{};   // as reported, x, y, z in the sensor's own unit
    double turned_rad = 0.0;   // since the beginning, counter-clockwise, by the judge
    double travelled_m = 0.0;  // since the beginning, by the wheels where there are any
};

// A log as a magnetometer's calibration sees it.
struct MagneticLog {
    std::vector<MagneticSample> samples{};
    std::size_t broken = 0;  // readings that are no numbers, or whose time does not go on
    HeadingJudge judge = HeadingJudge::kNone;
    bool judges_disagree = false;  // gyro and encoders turn opposite ways
};

// The judge is the vehicle's source of heading where it turned, else the other one. Turning and
// travel are interpolated to the times of the field's readings.
MagneticLog readMagneticLog(std::span<const SensorReport> reports, const Vehicle& vehicle);

}  // namespace hedr
