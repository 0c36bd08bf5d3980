#pragma once

#include <cstdint>
#include <optional>

#include "radio/wire/reports.h"
#include "radio/wire/text_line/text_layout.h"

namespace hedr {

// Makes reports of the values of lines: sensors and pose of each, and once a second who the robot
// is and its battery.
class TextReporter {
  public:
    // What the robot has; more of it with each call.
    void learn(const TextLayout& layout);
    void restart();
    void report(const TextSample& sample, double robot_time_s, const OnReport& on_report);

  private:
    HelloReport hello() const;
    Gyro gyroOf(const TextSample& sample);
    GyroAngle follow(double heading_rad);

    std::uint32_t boot_id_ = 1;
    std::uint16_t capabilities_ = 0;
    std::optional<double> hello_time_s_{};
    std::optional<double> last_heading_rad_{};
    double turned_rad_ = 0.0;  // whole turns counted
};

}  // namespace hedr
