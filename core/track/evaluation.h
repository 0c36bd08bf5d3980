#pragma once

#include <cstddef>
#include <vector>

#include "core/result.h"
#include "core/track/track.h"

namespace hedr {

enum class Alignment {
    kNone,
    kStart,  // the first matched pose lies on the truth; where a heading is unknown, the first
             // fifth of the estimate's path tells the rotation (least squares)
    kRigid,  // least squares of all matched positions, rotation and shift (Umeyama, no scale)
};

// How far an estimate lies from the truth. Each truth sample is matched with the estimate nearest
// in time, within half a median period of the slower of the two; no estimate is matched twice.
// Heading errors are estimate minus truth, followed over full turns, so that a drift of 250° is
// 250° and not -110°. They are NaN where the truth or the estimate has no heading.
struct Evaluation {
    std::size_t samples = 0;
    double duration_s = 0.0;
    double distance_m = 0.0;  // along the truth
    double end_position_error_m = 0.0;
    double end_heading_error_deg = 0.0;          // signed
    double return_position_error_m = 0.0;        // of the estimate, first to last pose
    double return_position_error_percent = 0.0;  // of distance_m; NaN where the truth stands still
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
