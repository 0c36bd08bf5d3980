#pragma once

#include <string>
#include <vector>

#include "core/robot/report.h"

namespace hedr {

// What one log, or one start of a robot in a mission, gives to a calibration.
struct SampleSet {
    std::string origin;  // a log, a mission, "live"
    std::vector<SensorReport> reports{};
};

}  // namespace hedr
