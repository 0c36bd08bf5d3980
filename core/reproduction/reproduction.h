#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace hedr {

// Either end may be infinite.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool holds(double value) const { return value >= low && value <= high; }
};

inline Range atLeast(double low) { return {.low = low}; }
inline Range atMost(double high) { return {.high = high}; }
inline Range within(double low, double high) { return {low, high}; }

// One figure of a paper and ours beside it.
struct Figure {
    std::string name;
    std::string place;  // in the paper
    std::string paper;  // as the paper says it, with its unit; empty where it says nothing
    std::optional<double> ours{};
    std::string unit{};
    std::optional<Range> agrees_within{};  // none: reported only
    bool set_to_match = false;             // a parameter of the simulation was chosen for it
    std::string note{};                    // the reason, see needsReason

    // None where there is nothing to agree with.
    std::optional<bool> agrees() const {
        if (!ours || !agrees_within) return std::nullopt;
        return agrees_within->holds(*ours);
    }

    // A figure that is missing, does not agree, or was made to agree.
    bool needsReason() const { return !ours || set_to_match || agrees() == false; }
};

struct Reproduction {
    std::vector<Figure> figures;
    std::vector<std::string> remarks;  // what the paper concludes and its own figures contradict
};

struct ReproductionOptions {
    int seeds = 20;
    std::function<void(int done, int total)> progress = [](int, int) {};
};

}  // namespace hedr
