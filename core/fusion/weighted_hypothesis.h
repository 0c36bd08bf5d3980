#pragma once

#include <cmath>

#include "core/fusion/heading_hypothesis.h"

namespace hedr {

// Of its own direction: straight on, or bent.
enum class LegKind : unsigned char { kNone, kCorridor, kDiagonal, kOwn, kOwnBent };

struct WeightedHypothesis {
    HeadingHypothesis hypothesis;
    double log_weight = 0.0;
    LegKind leg = LegKind::kNone;       // of the leg that it drives
    LegKind last = LegKind::kCorridor;  // of the leg before
    bool building = true;               // false: nothing here runs in few directions

    double weight() const { return std::exp(log_weight); }
};

inline constexpr double kQuarterTurn_rad = kPi / 2.0;  // a building looks the same after it

}  // namespace hedr
