#include "ui/site/tie_draft.h"

#include <algorithm>

namespace hedr {

TieDraft draftOf(const std::optional<GeoTie>& tie) {
    if (!tie) return {};
    return {.places = {{tie->point, tie->at}}, .bearing_of_y_rad = tie->bearing_of_y_rad};
}

TieFit tieOf(const TieDraft& draft) {
    std::vector<GeoPoint> known;
    for (const TiePlace& place : draft.places) {
        if (place.at) known.push_back({place.world, *place.at});
    }
    if (known.empty()) return {};
    if (known.size() == 1) {
        return {.tie = GeoTie{known[0].point, known[0].at, draft.bearing_of_y_rad}};
    }
    const auto by_two = tieByTwoPoints(known[0], known[1]);
    if (!by_two) return {.error = by_two.error()};
    return {.tie = by_two->tie, .by_two = *by_two};
}

}  // namespace hedr
