#pragma once

#include <vector>

#include "core/calibration/calibration.h"
#include "radio/wire/request.h"

namespace hedr {

// What of a calibration the robot has parameters for, in the wire's units; values that stay, and
// those that do not fit, are left out.
std::vector<ParameterSet> robotParametersIn(const Calibration& calibration);

}  // namespace hedr
