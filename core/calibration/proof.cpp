#include "core/calibration/proof.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/calibration/jackknife.h"

namespace hedr {

namespace {

struct SquareSums {
    double before = 0.0;
    double after = 0.0;

    void add(const HeldOutError& part, double sign) {
        before += sign * part.before * part.before;
        after += sign * part.after * part.after;
    }
    // Of the root of their ratio. No error at all counts as a very small one.
    double logTimesBetter() const {
        constexpr double kTiny = std::numeric_limits<double>::min();
        return 0.5 * std::log(std::max(before, kTiny) / std::max(after, kTiny));
    }
};

SquareSums sumsOf(std::span<const HeldOutError> parts) {
    SquareSums sums;
    for (const HeldOutError& part : parts) sums.add(part, 1.0);
    return sums;
}

// Delete-one jackknife: parts need not have the same variance, nor normal errors.
Estimate logTimesBetter(std::span<const HeldOutError> parts) {
    const SquareSums all = sumsOf(parts);
    std::vector<double> without;
    without.reserve(parts.size());
    for (const HeldOutError& part : parts) {
        SquareSums rest = all;
        rest.add(part, -1.0);
        without.push_back(rest.logTimesBetter());
    }
    return jackknifed(all.logTimesBetter(), without);
}

Interval exponentiated(const Interval& logarithm) {
    return {std::exp(logarithm.low), std::exp(logarithm.high)};
}

}  // namespace

Proof proofOf(std::span<const HeldOutError> parts, std::string what, std::string unit) {
    Proof proof{.what = std::move(what), .unit = std::move(unit), .parts = parts.size()};
    if (parts.empty()) return proof;
    const SquareSums sums = sumsOf(parts);
    const double n = static_cast<double>(parts.size());
    proof.before = std::sqrt(sums.before / n);
    proof.after = std::sqrt(sums.after / n);
    if (parts.size() < Proof::kFewestParts) return proof;
    const Estimate log_times = logTimesBetter(parts);
    proof.times_better = std::exp(log_times.value);
    proof.times_better_95 = exponentiated(log_times.interval(0.95));
    proof.times_better_99 = exponentiated(log_times.interval(0.99));
    return proof;
}

}  // namespace hedr
