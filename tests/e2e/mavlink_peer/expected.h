#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>

#include "radio/wire/mavlink/mavlink_messages.h"

namespace hedr {

// What mavlink_peer/motion.mjs says, field by field, in MAVLink's axes and units.

inline constexpr double kPeerStart_s = 100.0;  // since boot, when the drive begins
inline constexpr double kPeerRate_rad_s = 0.2;
inline constexpr double kPeerRadius_m = 5.0;
inline constexpr double kPeerTrack_m = 0.5;

inline double peerYaw_rad(double s) { return kPeerRate_rad_s * s; }
inline double peerNorth_m(double s) { return kPeerRadius_m * std::sin(peerYaw_rad(s)); }
inline double peerEast_m(double s) { return kPeerRadius_m * (1.0 - std::cos(peerYaw_rad(s))); }
inline double peerLeft_m(double s) { return (1.0 + kPeerRate_rad_s * kPeerTrack_m / 2.0) * s; }
inline double peerRight_m(double s) { return (1.0 - kPeerRate_rad_s * kPeerTrack_m / 2.0) * s; }

struct PeerMoment {
    double s = 0.0;        // since the drive began
    std::uint32_t ms = 0;  // since boot
    std::uint64_t us() const { return 1000U * std::uint64_t{ms}; }
};

template <class Message>
PeerMoment momentOf(const Message& m) {
    std::uint32_t ms = 0;
    if constexpr (requires { m.time_boot_ms; }) ms = m.time_boot_ms;
    if constexpr (requires { m.time_usec; }) ms = static_cast<std::uint32_t>(m.time_usec / 1000U);
    return {1e-3 * ms - kPeerStart_s, ms};
}

inline float asFloat(double value) { return static_cast<float>(value); }

inline void expectedAt(PeerMoment, MavlinkHeartbeat& m) {
    m = {.custom_mode = 305419896,
         .type = 10,
         .autopilot = 0,
         .base_mode = 81,
         .system_status = 4,
         .mavlink_version = 3};
}
inline void expectedAt(PeerMoment, MavlinkSysStatus& m) {
    m = {.onboard_control_sensors_present = 0x02008001,
         .onboard_control_sensors_enabled = 0x02008001,
         .onboard_control_sensors_health = 0x00008000,
         .load = 321,
         .voltage_battery = 12340,
         .current_battery = -567,
         .drop_rate_comm = 89,
         .errors_comm = 12,
         .errors_count = {1, 2, 3, 4},
         .battery_remaining = 76,
         .onboard_control_sensors_present_extended = 5,
         .onboard_control_sensors_enabled_extended = 6,
         .onboard_control_sensors_health_extended = 7};
}
inline void expectedAt(PeerMoment, MavlinkRadioStatus& m) {
    m = {.rxerrors = 513,
         .fixed = 258,
         .rssi = 190,
         .remrssi = 171,
         .txbuf = 99,
         .noise = 38,
         .remnoise = 39};
}
inline void expectedAt(PeerMoment at, MavlinkAttitude& m) {
    m = {.time_boot_ms = at.ms,
         .roll = 0.0625F,
         .pitch = -0.125F,
         .yaw = asFloat(peerYaw_rad(at.s)),
         .rollspeed = 0.03125F,
         .pitchspeed = -0.25F,
         .yawspeed = 0.2F};
}
inline void expectedAt(PeerMoment at, MavlinkLocalPositionNed& m) {
    m = {.time_boot_ms = at.ms,
         .x = asFloat(peerNorth_m(at.s)),
         .y = asFloat(peerEast_m(at.s)),
         .z = -0.5F,
         .vx = asFloat(std::cos(peerYaw_rad(at.s))),
         .vy = asFloat(std::sin(peerYaw_rad(at.s))),
         .vz = 0.0625F};
}
inline void expectedAt(PeerMoment at, MavlinkOdometry& m) {
    const double half_rad = peerYaw_rad(at.s) / 2.0;
    m = {.time_usec = at.us(),
         .x = asFloat(peerNorth_m(at.s)),
         .y = asFloat(peerEast_m(at.s)),
         .z = -0.5F,
         .q = {asFloat(std::cos(half_rad)), 0.0F, 0.0F, asFloat(std::sin(half_rad))},
         .vx = 1.0F,
         .vy = 0.5F,
         .vz = 0.0625F,
         .rollspeed = 0.03125F,
         .pitchspeed = -0.25F,
         .yawspeed = 0.2F,
         .frame_id = 1,
         .child_frame_id = 12,
         .reset_counter = 3,
         .estimator_type = 2,
         .quality = 88};
    std::iota(m.pose_covariance.begin(), m.pose_covariance.end(), 1.0F);
    std::iota(m.velocity_covariance.begin(), m.velocity_covariance.end(), 101.0F);
}
inline void expectedAt(PeerMoment at, MavlinkWheelDistance& m) {
    m = {.time_usec = at.us(), .count = 2};
    std::iota(m.distance.begin(), m.distance.end(), 0.0);
    m.distance[0] = peerLeft_m(at.s);
    m.distance[1] = peerRight_m(at.s);
}
inline void expectedAt(PeerMoment at, MavlinkScaledImu& m) {
    m = {.time_boot_ms = at.ms,
         .xacc = 11,
         .yacc = -12,
         .zacc = -1001,
         .xgyro = 21,
         .ygyro = -22,
         .zgyro = 200,
         .xmag = 210,
         .ymag = 30,
         .zmag = -430,
         .temperature = 2150};
}
inline void expectedAt(PeerMoment at, MavlinkRawImu& m) {
    m = {.time_usec = at.us(),
         .xacc = 13,
         .yacc = -14,
         .zacc = -1002,
         .xgyro = 23,
         .ygyro = -24,
         .zgyro = 200,
         .xmag = 220,
         .ymag = -40,
         .zmag = 440,
         .id = 1,
         .temperature = -350};
}
inline void expectedAt(PeerMoment at, MavlinkHighresImu& m) {
    m = {.time_usec = at.us(),
         .xacc = 0.5F,
         .yacc = -0.25F,
         .zacc = -9.75F,
         .xgyro = 0.03125F,
         .ygyro = -0.0625F,
         .zgyro = 0.2F,
         .xmag = 0.25F,
         .ymag = 0.125F,
         .zmag = -0.5F,
         .abs_pressure = 1013.25F,
         .diff_pressure = 0.75F,
         .pressure_alt = 120.5F,
         .temperature = 36.5F,
         .fields_updated = 0x1FFF,
         .id = 2};
}

}  // namespace hedr
