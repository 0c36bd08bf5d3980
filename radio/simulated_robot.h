#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/robot/report.h"
#include "core/robot/vehicle.h"
#include "radio/firmware/hedr_robot.h"

namespace hedr {

// A robot that runs the firmware header on given sensor values: what it says is what a
// microcontroller would say.
class SimulatedRobot {
  public:
    using Send = std::function<void(std::span<const std::uint8_t> frame)>;

    SimulatedRobot(const Vehicle& vehicle, const Pose<World>& start);

    // One sample of its sensors: sends sensors, and as they fall due pose, hello and status.
    void sense(const SensorReport& report, const Send& send);
    // Bytes from the laptop: sends the answers.
    void hear(std::span<const std::uint8_t> bytes, const Send& send);
    // Power off and on: time, counters and pose start again from zero.
    void restart();

  private:
    void boot(const Pose<World>& start);
    void count(const Odometry& odometry);
    void sayHello(const Send& send);
    void sayPose(const Send& send);
    void saySensors(const SensorReport& report, const Send& send);
    void sayStatus(const Send& send);
    bool due(double& next_s, double period_s) const;

    Vehicle vehicle_;
    std::uint32_t boot_id_ = 0;
    hedr_robot robot_{};
    hedr_decoder decoder_{};
    std::uint16_t sequence_ = 0;
    double time_s_ = 0.0;
    std::optional<double> time_zero_s_{};  // of the sensor log, since the last restart
    Odometry last_odometry_{};
    double left_ticks_ = 0.0;
    double right_ticks_ = 0.0;
    bool has_gyro_ = false;
    bool has_magnetometer_ = false;
    double next_pose_s_ = 0.0;
    double next_slow_s_ = 0.0;
};

}  // namespace hedr
