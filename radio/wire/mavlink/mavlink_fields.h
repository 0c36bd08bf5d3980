#pragma once

#include "radio/wire/mavlink/mavlink_messages.h"

namespace hedr {

// The fields of each message in the order of the wire: io(name, field), where io is a
// MavlinkPayloadReader, a MavlinkPayloadWriter or, in a test, what computes crc_extra.

// M is Message or const Message.
template <class M, class Message>
concept MavlinkFields = std::same_as<std::remove_const_t<M>, Message>;

template <class Io, MavlinkFields<MavlinkHeartbeat> M>
void mavlinkFields(Io& io, M& m) {
    io("custom_mode", m.custom_mode);
    io("type", m.type);
    io("autopilot", m.autopilot);
    io("base_mode", m.base_mode);
    io("system_status", m.system_status);
    io("mavlink_version", m.mavlink_version);
}

template <class Io, MavlinkFields<MavlinkSysStatus> M>
void mavlinkFields(Io& io, M& m) {
    io("onboard_control_sensors_present", m.onboard_control_sensors_present);
    io("onboard_control_sensors_enabled", m.onboard_control_sensors_enabled);
    io("onboard_control_sensors_health", m.onboard_control_sensors_health);
    io("load", m.load);
    io("voltage_battery", m.voltage_battery);
    io("current_battery", m.current_battery);
    io("drop_rate_comm", m.drop_rate_comm);
    io("errors_comm", m.errors_comm);
    io("errors_count1", m.errors_count[0]);
    io("errors_count2", m.errors_count[1]);
    io("errors_count3", m.errors_count[2]);
    io("errors_count4", m.errors_count[3]);
    io("battery_remaining", m.battery_remaining);
    io.extensions();
    io("onboard_control_sensors_present_extended", m.onboard_control_sensors_present_extended);
    io("onboard_control_sensors_enabled_extended", m.onboard_control_sensors_enabled_extended);
    io("onboard_control_sensors_health_extended", m.onboard_control_sensors_health_extended);
}

template <class Io, MavlinkFields<MavlinkParamRequestRead> M>
void mavlinkFields(Io& io, M& m) {
    io("param_index", m.param_index);
    io("target_system", m.target_system);
    io("target_component", m.target_component);
    io("param_id", m.param_id);
}

template <class Io, MavlinkFields<MavlinkParamValue> M>
void mavlinkFields(Io& io, M& m) {
    io("param_value", m.param_value);
    io("param_count", m.param_count);
    io("param_index", m.param_index);
    io("param_id", m.param_id);
    io("param_type", m.param_type);
}

template <class Io, MavlinkFields<MavlinkParamSet> M>
void mavlinkFields(Io& io, M& m) {
    io("param_value", m.param_value);
    io("target_system", m.target_system);
    io("target_component", m.target_component);
    io("param_id", m.param_id);
    io("param_type", m.param_type);
}

// What SCALED_IMU, RAW_IMU and HIGHRES_IMU have in common.
template <class Io, class M>
void mavlinkAxes(Io& io, M& m) {
    io("xacc", m.xacc);
    io("yacc", m.yacc);
    io("zacc", m.zacc);
    io("xgyro", m.xgyro);
    io("ygyro", m.ygyro);
    io("zgyro", m.zgyro);
    io("xmag", m.xmag);
    io("ymag", m.ymag);
    io("zmag", m.zmag);
}

template <class Io, MavlinkFields<MavlinkScaledImu> M>
void mavlinkFields(Io& io, M& m) {
    io("time_boot_ms", m.time_boot_ms);
    mavlinkAxes(io, m);
    io.extensions();
    io("temperature", m.temperature);
}

template <class Io, MavlinkFields<MavlinkRawImu> M>
void mavlinkFields(Io& io, M& m) {
    io("time_usec", m.time_usec);
    mavlinkAxes(io, m);
    io.extensions();
    io("id", m.id);
    io("temperature", m.temperature);
}

template <class Io, MavlinkFields<MavlinkAttitude> M>
void mavlinkFields(Io& io, M& m) {
    io("time_boot_ms", m.time_boot_ms);
    io("roll", m.roll);
    io("pitch", m.pitch);
    io("yaw", m.yaw);
    io("rollspeed", m.rollspeed);
    io("pitchspeed", m.pitchspeed);
    io("yawspeed", m.yawspeed);
}

template <class Io, MavlinkFields<MavlinkLocalPositionNed> M>
void mavlinkFields(Io& io, M& m) {
    io("time_boot_ms", m.time_boot_ms);
    io("x", m.x);
    io("y", m.y);
    io("z", m.z);
    io("vx", m.vx);
    io("vy", m.vy);
    io("vz", m.vz);
}

template <class Io, MavlinkFields<MavlinkCommandLong> M>
void mavlinkFields(Io& io, M& m) {
    io("param1", m.param[0]);
    io("param2", m.param[1]);
    io("param3", m.param[2]);
    io("param4", m.param[3]);
    io("param5", m.param[4]);
    io("param6", m.param[5]);
    io("param7", m.param[6]);
    io("command", m.command);
    io("target_system", m.target_system);
    io("target_component", m.target_component);
    io("confirmation", m.confirmation);
}

template <class Io, MavlinkFields<MavlinkCommandAck> M>
void mavlinkFields(Io& io, M& m) {
    io("command", m.command);
    io("result", m.result);
    io.extensions();
    io("progress", m.progress);
    io("result_param2", m.result_param2);
    io("target_system", m.target_system);
    io("target_component", m.target_component);
}

template <class Io, MavlinkFields<MavlinkHighresImu> M>
void mavlinkFields(Io& io, M& m) {
    io("time_usec", m.time_usec);
    mavlinkAxes(io, m);
    io("abs_pressure", m.abs_pressure);
    io("diff_pressure", m.diff_pressure);
    io("pressure_alt", m.pressure_alt);
    io("temperature", m.temperature);
    io("fields_updated", m.fields_updated);
    io.extensions();
    io("id", m.id);
}

template <class Io, MavlinkFields<MavlinkRadioStatus> M>
void mavlinkFields(Io& io, M& m) {
    io("rxerrors", m.rxerrors);
    io("fixed", m.fixed);
    io("rssi", m.rssi);
    io("remrssi", m.remrssi);
    io("txbuf", m.txbuf);
    io("noise", m.noise);
    io("remnoise", m.remnoise);
}

template <class Io, MavlinkFields<MavlinkTimesync> M>
void mavlinkFields(Io& io, M& m) {
    io("tc1", m.tc1);
    io("ts1", m.ts1);
    io.extensions();
    io("target_system", m.target_system);
    io("target_component", m.target_component);
}

template <class Io, MavlinkFields<MavlinkStatustext> M>
void mavlinkFields(Io& io, M& m) {
    io("severity", m.severity);
    io("text", m.text);
    io.extensions();
    io("id", m.id);
    io("chunk_seq", m.chunk_seq);
}

template <class Io, MavlinkFields<MavlinkOdometry> M>
void mavlinkFields(Io& io, M& m) {
    io("time_usec", m.time_usec);
    io("x", m.x);
    io("y", m.y);
    io("z", m.z);
    io("q", m.q);
    io("vx", m.vx);
    io("vy", m.vy);
    io("vz", m.vz);
    io("rollspeed", m.rollspeed);
    io("pitchspeed", m.pitchspeed);
    io("yawspeed", m.yawspeed);
    io("pose_covariance", m.pose_covariance);
    io("velocity_covariance", m.velocity_covariance);
    io("frame_id", m.frame_id);
    io("child_frame_id", m.child_frame_id);
    io.extensions();
    io("reset_counter", m.reset_counter);
    io("estimator_type", m.estimator_type);
    io("quality", m.quality);
}

template <class Io, MavlinkFields<MavlinkWheelDistance> M>
void mavlinkFields(Io& io, M& m) {
    io("time_usec", m.time_usec);
    io("distance", m.distance);
    io("count", m.count);
}

}  // namespace hedr
