#pragma once

#include <vector>

#include "core/result.h"
#include "core/track/track.h"

namespace hedr {

enum class Alignment { kNone, kStart, kRigid };

// How far an estimate lies from the truth. Samples are matched by time, nearest within half a
// period of the truth.
struct Evaluation {
    std::size_t samples = 0;
    double duration_s = 0.0;
    double distance_m = 0.0;  // along the truth
    double end_position_error_m = 0.0;
    double end_heading_error_deg = 0.0;
    double return_position_error_m = 0.0;  // of the estimate, first to last pose
    double return_position_error_percent = 0.0;
    double heading_rmse_deg = 0.0;
    double heading_max_deg = 0.0;
    double ape_rmse_m = 0.0;
    double ape_mean_m = 0.0;
    double ape_median_m = 0.0;
    double ape_max_m = 0.0;
};

// Errors: kNoData where no sample of the two matches in time.
Result<Evaluation> evaluate(const std::vector<TrackPoint>& estimate,
                            const std::vector<TrackPoint>& truth, Alignment alignment);

}  // namespace hedr
