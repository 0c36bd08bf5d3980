#pragma once

#include <span>
#include <string>

#include "core/calibration/gyro/warmup.h"

namespace hedr {

// What the operator sees of a warm-up, into its calibration: steps, progress, figures, plots and
// remarks.
void addWarmupEvidence(Warmup& warmup, std::span<const WarmupBlock> blocks,
                       const WarmupOptions& options);

std::string spokenTime(double time_s);  // "85 s", "12 min"

}  // namespace hedr
