#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "core/simulation/building.h"
#include "core/simulation/random.h"

namespace hedr {

// A wander through the corridors that never turns back in a corridor and comes home in time.
class Route {
  public:
    Route(CorridorGraph corridors, std::size_t home);

    // The node after `at`, for a robot that came from `from` and may still drive `budget_m`.
    // None: it is at home, and no further round fits.
    std::optional<std::size_t> next(std::size_t from, std::size_t at, double budget_m,
                                    Random& random);

  private:
    using Leg = std::pair<std::size_t, std::size_t>;

    void measureWaysHome();

    CorridorGraph corridors_;
    std::size_t home_;
    std::map<Leg, double> way_home_m_;  // from the end of a leg
    std::map<Leg, int> visits_;
};

}  // namespace hedr
