#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/gyro_samples.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// A time that the robot stood before, between or after turns.
struct GyroStand {
    double begin_s = 0.0;
    double end_s = 0.0;
    double mean_rad_s = 0.0;  // of the gyro, as reported
    double span_s = 0.0;      // of the readings that the mean is made of

    double middle_s() const { return 0.5 * (begin_s + end_s); }
};

struct GyroStands {
    std::vector<GyroStand> stands{};
    double noise_rad_s_sqrthz = 0.0;  // of the gyro, as reported, while it stands
    double degrees_of_freedom = 0.0;  // of that
    double rounding_rad_s = 0.0;      // error of every mean where the readings are coarse
};

// The readings with what stands alone replaced by its neighbours: no robot turns for one reading.
std::vector<GyroSample> withoutLoneReadings(std::vector<GyroSample> samples);

// Times of standing of two seconds or more: the gyro stays within half a degree per second of what
// it says when it first is steady, or of its noise, following a slow drift of its bias, and the
// wheels do not count. The robot has to stand before it turns. The first moment and the last one of
// each are left out. `gyro_scale`: of the vehicle.
GyroStands standsIn(std::span<const GyroSample> samples, std::span<const SensorReport> reports,
                    const Vehicle& vehicle);

}  // namespace hedr
