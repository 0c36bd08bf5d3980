#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/sample_set.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// What the encoders said at one time, by the believed vehicle.
struct EncoderMoment {
    double t_s = 0.0;
    double left_m = 0.0;  // travelled since the beginning, signed
    double right_m = 0.0;
    double gyro_rad = 0.0;  // turned since the beginning, bias removed as far as it is known
};

// The encoders in one test: the robot stands, moves and stands again.
struct EncoderTravel {
    std::vector<EncoderMoment> moments{};
    bool has_sides = true;  // left and right are told apart
    bool has_gyro = false;
    bool knows_gyro_bias = false;  // from standing, or from the vehicle file
    double moved_from_s = 0.0;     // first and last count; equal: none
    double moved_until_s = 0.0;
    std::size_t broken = 0;  // readings left out: no numbers, or a step that no wheel can make

    double left_m() const { return moments.empty() ? 0.0 : moments.back().left_m; }
    double right_m() const { return moments.empty() ? 0.0 : moments.back().right_m; }
    double gyro_rad() const { return moments.empty() ? 0.0 : moments.back().gyro_rad; }
    bool moved() const { return moved_until_s > moved_from_s; }
    bool stands() const;  // for a while, at the end
};

EncoderTravel readEncoderTravel(std::span<const SensorReport> reports, const Vehicle& vehicle);

using EncoderTestLogs = std::vector<std::span<const SensorReport>>;

// The tests that a log holds, in their order: the robot stands for two seconds or more between
// them. `least_m`: a wheel that travelled less has not been moved.
EncoderTestLogs encoderTestsIn(const SampleSet& log, const Vehicle& vehicle, double least_m);

// The same of several logs, which hold one test each.
EncoderTestLogs encoderTestsIn(std::span<const SampleSet> logs, const Vehicle& vehicle,
                               double least_m);

}  // namespace hedr
