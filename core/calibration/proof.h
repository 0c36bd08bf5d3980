#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibration/estimate.h"

namespace hedr {

// How far one held-out part of the data (a square, a turn, a block of a drive) is off when it is
// computed with the old and with the new parameters. It had no share in the new ones.
struct HeldOutError {
    double before = 0.0;
    double after = 0.0;
};

// Whether held-out data say that the new parameters are better. Nothing is accepted without.
struct Proof {
    std::string what;  // "return position error", as the operator reads it
    std::string unit;  // "m"; SI, angles in rad
    std::size_t parts = 0;
    double before = 0.0;  // root mean square over the parts
    double after = 0.0;
    double times_better = 1.0;       // before over after
    Interval times_better_95{1, 1};  // delete-one jackknife of the logarithm, Student's t
    Interval times_better_99{1, 1};  // which decides

    bool better() const { return parts >= kFewestParts && times_better_99.low > 1.0; }
    bool worse() const { return parts >= kFewestParts && times_better_95.high < 1.0; }

    static constexpr std::size_t kFewestParts = 4;
    friend bool operator==(const Proof&, const Proof&) = default;
};

Proof proofOf(std::span<const HeldOutError> parts, std::string what, std::string unit);

}  // namespace hedr
