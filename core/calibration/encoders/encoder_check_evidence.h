#pragma once

#include "core/calibration/encoders/encoder_check.h"

namespace hedr {

// What the operator sees of the tests so far: fills steps, progress, figures, remarks and plots of
// check.calibration from the rest of it.
void addEvidence(EncoderCheck& check, const Vehicle& believed);

}  // namespace hedr
