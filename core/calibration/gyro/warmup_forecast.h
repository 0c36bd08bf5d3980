#pragma once

#include <optional>

#include "core/calibration/gyro/warmup_fit.h"

namespace hedr {

// T is known, and with it what the curve will do, when its relative standard error is below this.
inline constexpr double kKnownTimeError = 0.12;

// What it costs to drive now, as a mean over the next ten minutes; 95 % are better.
struct WarmupCost {
    double held_rad_s = 0.0;   // with the bias as it is now
    double curve_rad_s = 0.0;  // with the curve, which does not know the room
};

WarmupCost costOfStarting(const WarmupFit& fit, double on_s);

// How much longer the robot has to stand until T is known, if all goes on as it was found; none
// where that is far beyond what was seen. `on_before_s`: switched on before it was watched.
std::optional<double> knownIn_s(const WarmupFit& fit, double on_before_s, double stood_s);

// How much longer it takes until what is left of the drift is below that.
double settledIn_s(const GyroDrift& curve, double on_s, double matters_rad_s);

}  // namespace hedr
