#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "radio/wire/mavlink/mavlink_axes.h"
#include "radio/wire/mavlink/mavlink_choice.h"
#include "radio/wire/mavlink/mavlink_clock.h"
#include "radio/wire/mavlink/mavlink_decoder.h"
#include "radio/wire/mavlink/mavlink_requests.h"
#include "radio/wire/mavlink/mavlink_text.h"
#include "radio/wire/reports.h"

namespace hedr {

// The reports in a stream of MAVLink, in SI units and our axes (mavlink_axes.h); docs/mavlink.md
// tells which message becomes what. It sees nothing but bytes: the same bytes give the same
// reports, however they are cut.
//
// One vehicle is followed: the first whose autopilot (component 1) sends a heartbeat, until then
// the first that sends any. Ground stations are none.
class MavlinkReports {
  public:
    void feed(std::span<const std::uint8_t> bytes, const OnReport& on_report);
    // Bytes that follow do not continue those before.
    void portOpened() { decoder_.startAgain(); }

    const WireCounters& counters() const { return decoder_.counters(); }
    // Good frames of the vehicle that is followed; none of its companions, modems or stations.
    std::uint64_t robotFrames() const { return robot_frames_; }
    std::uint64_t signedFrames() const { return decoder_.signedFrames(); }
    // To whom requests go; none before its first heartbeat.
    const std::optional<MavlinkAddress>& vehicle() const { return vehicle_; }
    MavlinkParameterCoding parameterCoding() const;
    // The messages that it takes to follow the vehicle, as its autopilot knows them.
    std::array<std::uint32_t, 4> neededMessages() const;

  private:
    // A message's sender, and who wants to know.
    struct Context {
        MavlinkAddress from{};
        const OnReport& on_report;
    };
    struct Attitude {
        double robot_time_s = 0.0;
        MavlinkYaw yaw{};
    };

    void take(const MavlinkFrame& frame, const OnReport& on_report);
    void take(const MavlinkHeartbeat& m, const Context& context);
    void take(const MavlinkSysStatus& m, const Context& context);
    void take(const MavlinkParamValue& m, const Context& context);
    void take(const MavlinkScaledImu& m, const Context& context);
    void take(const MavlinkRawImu& m, const Context& context);
    void take(const MavlinkHighresImu& m, const Context& context);
    void take(const MavlinkAttitude& m, const Context& context);
    void take(const MavlinkLocalPositionNed& m, const Context& context);
    void take(const MavlinkOdometry& m, const Context& context);
    void take(const MavlinkWheelDistance& m, const Context& context);
    void take(const MavlinkCommandAck& m, const Context& context);
    void take(const MavlinkRadioStatus& m, const Context& context);
    void take(const MavlinkTimesync& m, const Context& context);
    void take(const MavlinkStatustext& m, const Context& context);

    template <class Imu>
    void takeImu(MavlinkSensor sensor, const Imu& m, const Context& context);
    // The message's robot time, where it is one that is used.
    template <class Message>
    std::optional<double> use(MavlinkSensor sensor, const Message& m, const Context& context);
    template <class Stamp>
    double robotTime_s(const Stamp& stamp, const Context& context);

    void follow(MavlinkAddress address);
    void restart(const Context& context);
    void sayHello(const Context& context);
    void sayStatus(const Context& context);
    void sayPose(double robot_time_s, Pose<World> pose, double yaw_rate_rad_s,
                 const Context& context);
    void saySensors(SensorReport report, const Context& context);

    MavlinkDecoder decoder_;
    std::optional<MavlinkAddress> vehicle_{};
    std::uint64_t robot_frames_ = 0;
    std::uint8_t autopilot_ = 0;  // MAV_AUTOPILOT
    std::uint32_t boot_id_ = 0;
    MavlinkClock clock_;
    MavlinkChoice choice_;
    MavlinkTexts texts_;
    StatusReport status_{};
    bool has_temperature_ = false;
    bool has_magnetometer_ = false;

    std::optional<Attitude> attitude_{};
    std::optional<double> heading_rad_{};  // of the last pose, with its full turns
    Odometry odometry_{};                  // not yet reported
};

}  // namespace hedr
