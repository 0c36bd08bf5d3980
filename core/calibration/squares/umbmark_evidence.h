#pragma once

#include <cstddef>

#include "core/calibration/squares/umbmark_calibration.h"

namespace hedr {

std::size_t countOf(const UmbmarkCalibration& umbmark, Turning turning);  // squares that count

// The centre of gravity of a direction that is farther from 0: E_max,syst. `error`: before or
// after.
double largestSystematicError_m(const UmbmarkCalibration& umbmark,
                                Vector<Robot> UmbmarkSquare::*error);

// Steps and the plot, from the first square on.
void addUmbmarkSteps(UmbmarkCalibration& umbmark);
void addUmbmarkPlot(UmbmarkCalibration& umbmark);

// Progress, figures and remarks, once the ratios are known.
void addUmbmarkFigures(UmbmarkCalibration& umbmark);

}  // namespace hedr
