#pragma once

#include <limits>

namespace hedr {

struct Interval {
    double low = 0.0;
    double high = 0.0;

    bool contains(double value) const { return low <= value && value <= high; }
    friend bool operator==(const Interval&, const Interval&) = default;
};

inline constexpr double kUsualConfidence = 0.95;

// A parameter as it was found from samples, in the unit that goes with its name.
struct Estimate {
    double value = 0.0;
    double standard_error = 0.0;
    // Of the standard error, which was itself found from samples; infinite: it is known.
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
    // By which share of the margin the interval reaches further up than down: -1 to 1.
    double lopsided = 0.0;

    // Where the true value lies with that probability, by Student's t.
    Interval interval(double confidence = kUsualConfidence) const;
    // Half of its width.
    double margin(double confidence = kUsualConfidence) const;
    // Whether the true value is on this side of the middle between both with that confidence, by
    // whatever else `value` may be wrong.
    bool isNearerThan(double other, double confidence, double unsure = 0.0) const;
    friend bool operator==(const Estimate&, const Estimate&) = default;
};

// The value with such a 95 % interval around it.
Estimate estimateWithin(double value, const Interval& interval_95, double degrees_of_freedom);

}  // namespace hedr
