#pragma once

#include <vector>

#include "core/fusion/weighted_hypothesis.h"

namespace hedr {

// Merges hypotheses that say nearly the same, the closest pair first (Runnalls, "Kullback-Leibler
// Approach to Gaussian Mixture Reduction", 2007).
void mergeClose(std::vector<WeightedHypothesis>& hypotheses);

}  // namespace hedr
