#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/calibration/squares/square_runs.h"

namespace hedr {

std::string sentenceOf(const LeftOutRun& run);  // "Run 3 turned both ways."

// A length as it is read: "14 cm", "3.2 mm".
std::string readLength(double length_m);

// "run 3", "runs 3 and 4", "runs 1, 3 and 5 to 8".
std::string runsText(const std::vector<std::size_t>& numbers);

}  // namespace hedr
