#pragma once

#include <vector>

#include "core/calibration/calibration.h"
#include "radio/wire/request.h"

namespace hedr {

// What a robot is to be told of a calibration, in the wire's units: all its wheels, as soon as one
// number of them changes, for they belong together and it may have others than `believed`. Empty
// where nothing that it has a parameter for was found, or where a number does not fit.
std::vector<ParameterSet> robotParametersIn(const Calibration& calibration,
                                            const Vehicle& believed);

}  // namespace hedr
