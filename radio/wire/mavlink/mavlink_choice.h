#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace hedr {

// The messages that say how the vehicle moves.
enum class MavlinkSensor : std::uint8_t {
    kHighresImu,
    kScaledImu,
    kRawImu,
    kAttitude,
    kOdometry,
    kLocalPosition,
    kWheelDistance,
};
inline constexpr std::size_t kMavlinkSensorCount = 7;

// Which of them are used, decided over the first two seconds of robot time by what is heard in
// them, and then kept: the track must not change its sensors while the robot drives.
class MavlinkChoice {
  public:
    // True where the choice is over and this message of this component is one that is used.
    // `preferred`: of several components that send the same, this one is followed.
    bool hear(MavlinkSensor sensor, std::uint8_t component, bool preferred, double robot_time_s);

    // As the vehicle's autopilot is known to fill RAW_IMU in mrad/s, it is better than ATTITUDE.
    void trustRawImu(bool trust) { trusts_raw_imu_ = trust; }

    bool made() const { return made_; }
    // One kind of message is the tick that gives a SensorReport: the best gyro that comes at least
    // half as often as any of them, else the pose, else the wheels.
    std::optional<MavlinkSensor> tick() const;
    // Where the pose comes from: ODOMETRY, else LOCAL_POSITION_NED with ATTITUDE.
    std::optional<MavlinkSensor> pose() const;
    bool gyro() const { return gyroSource().has_value(); }
    bool wheels() const { return heard(MavlinkSensor::kWheelDistance); }

  private:
    // Of one message: the component that is listened to, and how often it spoke before the choice.
    struct Source {
        std::optional<std::uint8_t> component{};
        int count = 0;
    };
    Source& source(MavlinkSensor sensor) { return sources_[static_cast<std::size_t>(sensor)]; }
    const Source& source(MavlinkSensor sensor) const {
        return sources_[static_cast<std::size_t>(sensor)];
    }
    bool heard(MavlinkSensor sensor) const { return source(sensor).component.has_value(); }
    std::optional<MavlinkSensor> gyroSource() const;

    std::array<Source, kMavlinkSensorCount> sources_{};
    std::optional<double> began_s_{};
    bool trusts_raw_imu_ = false;
    bool made_ = false;
};

}  // namespace hedr
