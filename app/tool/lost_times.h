#pragma once

#include <string>

#include "core/fusion/lost_times.h"

namespace hedr::tool {

// Says on standard error when an estimator's heading had nothing to hold on to: a line for each
// time, or one for all where they are many.
void tellLostTimes(const std::string& estimator, const LostTimes& lost);

}  // namespace hedr::tool
