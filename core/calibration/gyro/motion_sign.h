#pragma once

#include <string>

#include "core/calibration/gyro/gyro_stretch.h"

namespace hedr {

// Why a robot is taken to move.
struct MotionSign {
    enum class Kind : unsigned char {
        kCounted,      // the encoders counted
        kTurned,       // the gyro says so
        kTurnsSlowly,  // its rate has changed a little, for good as far as can be seen
        kVibrates,     // its readings scatter more than before
        kUnwatched     // no readings came
    };

    Kind kind = Kind::kTurned;
    double since_s = 0.0;
    double until_s = 0.0;
    double turn_rad = 0.0;     // kTurned: within that time
    double rate_rad_s = 0.0;   // kTurnsSlowly: change of rate
    double noise_ratio = 1.0;  // kVibrates: scatter over what it usually is; below 1: the other
                               // way round, it vibrated before
    double strength = 0.0;     // above 1: beyond the limit of what standing does
};

// "The robot turned by about 0.2° within 0.3 s."
std::string sentenceOf(const MotionSign& sign);

// The strongest hint of motion that ends after `from_s`; with a strength of 1 or less it is no
// sign: it stands, as far as the gyro can tell. Noise and bias are learned from the stretch itself.
// Limits are set so that a standing gyro of the usual kinds shows a sign in fewer than 1 % of
// stretches of two minutes.
MotionSign strongestHintIn(const GyroStretch& stretch, double from_s);

}  // namespace hedr
