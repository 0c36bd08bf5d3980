#pragma once

#include <cmath>

#include "core/geometry/angle.h"
#include "tests/radio/wire/mavlink/spoken_mavlink.h"

namespace hedr::test {

// A circle to the left: 1 m/s, 0.2 rad/s, so of 5 m; in MAVLink's axes.
inline constexpr double kRate_rad_s = 0.2;
inline constexpr double kSpeed_m_s = 1.0;
inline constexpr double kTrack_m = 0.5;

inline float asFloat(double value) { return static_cast<float>(value); }

inline MavlinkAttitude attitudeAt(double t) {
    return {.time_boot_ms = static_cast<std::uint32_t>(std::lround(1000 * t)),
            .yaw = asFloat(wrapAngle(-kRate_rad_s * t)),
            .yawspeed = asFloat(-kRate_rad_s)};
}
inline MavlinkLocalPositionNed positionAt(double t) {
    const double r = kSpeed_m_s / kRate_rad_s;
    return {.time_boot_ms = static_cast<std::uint32_t>(std::lround(1000 * t)),
            .x = asFloat(r * std::sin(kRate_rad_s * t)),
            .y = asFloat(-r * (1 - std::cos(kRate_rad_s * t)))};
}
inline MavlinkOdometry odometryAt(double t) {
    const MavlinkLocalPositionNed p = positionAt(t);
    const double half = -kRate_rad_s * t / 2;
    return {.time_usec = static_cast<std::uint64_t>(std::llround(1e6 * t)),
            .x = p.x,
            .y = p.y,
            .q = {asFloat(std::cos(half)), 0, 0, asFloat(std::sin(half))},
            .yawspeed = asFloat(-kRate_rad_s),
            .frame_id = 1,
            .child_frame_id = 12};
}
inline MavlinkWheelDistance wheelsAt(double t) {
    return {.time_usec = static_cast<std::uint64_t>(std::llround(1e6 * t)),
            .distance = {(kSpeed_m_s - kRate_rad_s * kTrack_m / 2) * t,
                         (kSpeed_m_s + kRate_rad_s * kTrack_m / 2) * t},
            .count = 2};
}
// Each IMU has a rate of its own here, so that it is seen which is used.
inline MavlinkScaledImu scaledAt(double t) {
    return {.time_boot_ms = static_cast<std::uint32_t>(std::lround(1000 * t)), .zgyro = -201};
}
inline MavlinkRawImu rawAt(double t) {
    return {.time_usec = static_cast<std::uint64_t>(std::llround(1e6 * t)), .zgyro = -202};
}
inline MavlinkHighresImu highresAt(double t) {
    return {.time_usec = static_cast<std::uint64_t>(std::llround(1e6 * t)), .zgyro = -0.25F};
}

struct Heard {
    std::vector<SensorReport> sensors;
    std::vector<PoseReport> poses;
    std::vector<HelloReport> hellos;
};

inline Heard sorted(const std::vector<Report>& reports) {
    Heard heard;
    for (const Report& report : reports) {
        if (const auto* sensors = std::get_if<SensorReport>(&report))
            heard.sensors.push_back(*sensors);
        if (const auto* pose = std::get_if<PoseReport>(&report)) heard.poses.push_back(*pose);
        if (const auto* hello = std::get_if<HelloReport>(&report)) heard.hellos.push_back(*hello);
    }
    return heard;
}

// `say(robot, t)` every 10 ms from one second after boot on, a heartbeat each second.
template <class Say>
void drive(SpokenMavlink& robot, double seconds, Say say, std::uint8_t autopilot = 0,
           double from_s = 1.0) {
    for (int i = 0; i < std::lround(100 * seconds); ++i) {
        if (i % 100 == 0) robot.say(heartbeat(autopilot));
        say(robot, from_s + 0.01 * i);
    }
}

template <class Say>
Heard driven(double seconds, Say say, std::uint8_t autopilot = 0) {
    SpokenMavlink robot;
    drive(robot, seconds, say, autopilot);
    return sorted(robot.take());
}

inline double rateOf(const SensorReport& report) { return std::get<GyroRate>(report.gyro).rad_s; }

}  // namespace hedr::test
