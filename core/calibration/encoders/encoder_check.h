#pragma once

#include <span>
#include <vector>

#include "core/calibration/calibration.h"
#include "core/calibration/encoders/encoder_findings.h"
#include "core/calibration/sample_set.h"
#include "core/robot/vehicle.h"

namespace hedr {

struct EncoderCheckOptions {
    double distance_m = 1.0;     // pushed, by tape; negative: backwards
    double tape_error_m = 0.01;  // standard deviation, as hands and tapes go
    double turns = 1.0;          // spun, counter-clockwise positive
};

struct EncoderCheck {
    EncoderTests tests{};
    EncoderRatios ratios{};
    std::vector<EncoderFinding> findings{};
    Calibration calibration{};
};

// Whether the encoders are right, from two tests: the robot is pushed straight on by a known
// distance, then turned on the spot. A log for each, or one with both and two seconds of standing
// between them. Unchanged: they are. Refused: they are not, with what to do; only where the one
// fault is the ratio of counts to distance of both wheels, a new one is found, and judged by the
// gyro in the spin, which had no share in it. Not proven: a test is missing.
EncoderCheck checkEncoders(std::span<const SampleSet> logs, const Vehicle& believed,
                           const EncoderCheckOptions& options = {});

}  // namespace hedr
