#pragma once

#include "core/calibration/wheels/wheel_loops.h"

namespace hedr {

// What the operator sees of the loops so far: fills steps, progress, figures and plot of
// wheels.calibration from the rest of it.
void addEvidence(WheelLoops& wheels);

}  // namespace hedr
