#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace hedr {

struct GhGains {
    double alpha = 0.0;
    double beta = 0.0;
    double gamma = 0.0;
};

// One gain tried at several values, the others as they were.
struct TuningSweep {
    struct Trial {
        double value = 0.0;
        double error = 0.0;
    };
    double GhGains::*gain = nullptr;
    std::vector<Trial> trials;
    double chosen = 0.0;
};

struct Tuning {
    GhGains best{};
    double error = 0.0;  // with the best gains
    std::vector<TuningSweep> sweeps;
};

// The tuning procedure of the GH filter's paper (section X): one gain after the other over 0.1,
// 0.3, 0.5, 0.7, 0.9, then again in steps of 0.05 around the best. It finds a local optimum.
// `error` judges gains, less is better, not a number is worst; `go_on` is told before each trial
// how many were made of how many, and stops the search by returning false: then there is no result.
std::optional<Tuning> tuneGains(const GhGains& start,
                                const std::vector<double GhGains::*>& gains_to_tune,
                                const std::function<double(const GhGains&)>& error,
                                const std::function<bool(std::size_t, std::size_t)>& go_on);

}  // namespace hedr
