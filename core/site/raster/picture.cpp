#include "core/site/raster/picture.h"

#include <algorithm>

namespace hedr {
namespace {

constexpr double kUsualDpi = 150.0;
constexpr double kMostByDefault_px = 10'000.0;
constexpr double kInch_mm = 25.4;

}  // namespace

bool wasCanceled(const PictureJob& job, double share) {
    return job.progress && !job.progress(share);
}

double dpiOf(const PictureJob& job, double longer_side_mm) {
    const double inches = std::max(longer_side_mm, 1.0) / kInch_mm;
    if (job.longest_side_px > 0) return std::min(kUsualDpi, job.longest_side_px / inches);
    return job.choice.dpi.value_or(std::min(kUsualDpi, kMostByDefault_px / inches));
}

double pageResolution_m(const PlanChoice& choice, double dpi) {
    return choice.paper_scale * kInch_mm / 1000.0 / dpi;
}

}  // namespace hedr
