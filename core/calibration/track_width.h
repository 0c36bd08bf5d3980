#pragma once

#include <cstddef>
#include <string_view>

#include "core/calibration/estimate.h"

namespace hedr {

// The effective wheelbase in turns of about that rate: tracks slip the more the faster they turn,
// and otherwise on another floor.
struct TrackWidth {
    double rate_rad_s = 0.0;  // mean of the turns
    Estimate wheelbase_m{};
    std::size_t turns = 0;

    friend bool operator==(const TrackWidth&, const TrackWidth&) = default;
};

// The title of the plot of the wheelbase against the rate of turn.
inline constexpr std::string_view kTrackWidthPlot = "Wheelbase in each turn";

}  // namespace hedr
