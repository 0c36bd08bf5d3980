#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "core/track/evaluation.h"

namespace hedr::tool {

// evaluate(), with figures that can be shown. Errors: those of evaluate(); kBadValue, with
// `subject`, where the numbers are so large that there are none.
Result<Evaluation> compare(const std::vector<TrackPoint>& track,
                           const std::vector<TrackPoint>& truth, Alignment alignment,
                           const std::string& subject);

}  // namespace hedr::tool
