#include "app/tool/comparison.h"

#include <cmath>

namespace hedr::tool {

namespace {

// nullptr where all is well. A heading may be NaN, which is unknown, a position may not.
const char* overflowIn(const Evaluation& e) {
    for (const double figure_m : {e.distance_m, e.end_position_error_m, e.return_position_error_m,
                                  e.ape_rmse_m, e.ape_mean_m, e.ape_median_m, e.ape_max_m}) {
        if (!std::isfinite(figure_m)) return "positions";
    }
    for (const double figure_deg :
         {e.end_heading_error_deg, e.heading_rmse_deg, e.heading_max_deg}) {
        if (std::isinf(figure_deg)) return "headings";
    }
    return std::isfinite(e.duration_s) ? nullptr : "times";
}

}  // namespace

Result<Evaluation> compare(const std::vector<TrackPoint>& track,
                           const std::vector<TrackPoint>& truth, Alignment alignment,
                           const std::string& subject) {
    auto evaluation = evaluate(track, truth, alignment);
    if (!evaluation) return evaluation;
    const char* overflow = overflowIn(*evaluation);
    if (!overflow) return evaluation;
    return fail(ErrorCode::kBadValue, subject,
                std::string("its ") + overflow + " are too large to be compared");
}

}  // namespace hedr::tool
