#pragma once

#include <optional>
#include <vector>

#include "core/result.h"
#include "core/site/geo_tie.h"

namespace hedr {

// A place on the map, and where it is on the globe as far as that has been said.
struct TiePlace {
    Point<World> world{};
    std::optional<LatLon> at{};
    friend bool operator==(const TiePlace&, const TiePlace&) = default;
};

// What an operator has said of how the map lies on the globe. A value: undo keeps earlier ones.
struct TieDraft {
    static constexpr std::size_t kMostPlaces = 2;

    std::vector<TiePlace> places{};
    double bearing_of_y_rad = 0.0;  // counts with one place only
    friend bool operator==(const TieDraft&, const TieDraft&) = default;
};

TieDraft draftOf(const std::optional<GeoTie>& tie);

// What follows from a draft: neither, while no place has its coordinates.
struct TieFit {
    std::optional<GeoTie> tie{};
    std::optional<TwoPointTie> by_two{};
    std::optional<Error> error{};  // why two places make no tie
};
TieFit tieOf(const TieDraft& draft);

}  // namespace hedr
