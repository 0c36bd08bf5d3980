#pragma once

#include <cstdint>

#include "core/robot/report.h"

namespace hedr {

// Corridors of a minute, turned at their ends.
class LongDrive {
  public:
    SensorReport next() {
        const double t_s = 0.01 * static_cast<double>(count_++);
        const auto minute = static_cast<std::int64_t>(t_s / 60.0);
        const double in_minute_s = t_s - 60.0 * static_cast<double>(minute);
        const bool turning = in_minute_s > 57.0;
        left_ += turning ? -2 : 5;
        right_ += turning ? 2 : 5;
        const double turn_rad_s = turning ? 4.0 * 1e-3 / 0.5 / 0.01 : 0.0;
        return {.robot_time_s = t_s,
                .odometry = WheelTicks{left_, right_},
                .gyro = GyroRate{0.002 + turn_rad_s}};
    }

  private:
    std::int64_t count_ = 0;
    std::int64_t left_ = 0;
    std::int64_t right_ = 0;
};

}  // namespace hedr
