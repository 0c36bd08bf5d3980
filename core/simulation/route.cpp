#include "core/simulation/route.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace hedr {

Route::Route(CorridorGraph corridors, std::size_t home)
    : corridors_(std::move(corridors)), home_(home) {
    measureWaysHome();
}

// Bellman-Ford over the legs: a robot that must not turn back has one shortest way per leg.
void Route::measureWaysHome() {
    for (const auto& [a, b] : corridors_.edges) {
        for (const Leg& leg : {Leg{a, b}, Leg{b, a}}) {
            way_home_m_[leg] = leg.second == home_ ? 0.0 : std::numeric_limits<double>::infinity();
        }
    }
    for (std::size_t round = 0; round < way_home_m_.size(); ++round) {
        for (auto& [leg, way_m] : way_home_m_) {
            for (const std::size_t node : corridors_.neighbours(leg.second)) {
                if (node == leg.first) continue;
                way_m = std::min(way_m, corridors_.length_m(leg.second, node) +
                                            way_home_m_.at({leg.second, node}));
            }
        }
    }
}

std::optional<std::size_t> Route::next(std::size_t from, std::size_t at, double budget_m,
                                       Random& random) {
    std::vector<std::size_t> fitting;
    double weights = 0.0;
    double shortest_m = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> chosen;
    const auto weight = [&](std::size_t node) { return 1.0 / (1.0 + visits_[{at, node}]); };
    for (const std::size_t node : corridors_.neighbours(at)) {
        if (node == from) continue;
        const double way_m = corridors_.length_m(at, node) + way_home_m_.at({at, node});
        if (way_m <= budget_m) {
            fitting.push_back(node);
            weights += weight(node);
        }
        if (at != home_ && way_m < shortest_m) {
            shortest_m = way_m;
            chosen = node;
        }
    }
    double draw = weights * random.uniform();
    for (const std::size_t node : fitting) {
        chosen = node;
        draw -= weight(node);
        if (draw < 0.0) break;
    }
    if (chosen) ++visits_[{at, *chosen}];
    return chosen;
}

}  // namespace hedr
