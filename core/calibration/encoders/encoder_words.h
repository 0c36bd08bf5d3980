#pragma once

#include "core/calibration/encoders/encoder_findings.h"

namespace hedr {

// Fills the sentence and the advice of a finding from the rest of it.
void addWords(EncoderFinding& finding, const Vehicle& vehicle, const EncoderTests& tests);

// So many times: "4", "1.25", "1/4".
std::string factorText(double factor);

}  // namespace hedr
