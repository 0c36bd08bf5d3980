#pragma once

#include <span>
#include <vector>

#include "core/geometry/angle.h"
#include "core/robot/report.h"
#include "core/simulation/random.h"

namespace hedr {

// What keeps encoders and gyro of a tracked vehicle from the truth.
struct SensorErrors {
    double track_slip = 0.03;        // rms share of each track's travel, for about a second
    double turn_slip_spread = 0.07;  // rms change of the effective track width, as a share of it
    double gyro_bias_rad_s = radFromDeg(0.3);  // drawn from plus minus this
    double gyro_bias_walk_rad_s_sqrts = radFromDeg(0.004);
    double gyro_noise_rad_s_sqrthz = radFromDeg(0.05);  // angle random walk
    double gyro_scale_error = 0.0;
};

// The reports of a robot that stands and drives along `truth`, one every 1/rate_hz: encoder counts
// from 0 on, and the mean yaw rate since the last report. The geometry's wheelbase is the effective
// one, which a calibration by turning finds; the tracks' lateral slip in turns lets it vary.
std::vector<SensorReport> sensorReports(std::span<const Pose<World>> truth, double rate_hz,
                                        const VehicleGeometry& geometry, const SensorErrors& errors,
                                        Random& random);

}  // namespace hedr
