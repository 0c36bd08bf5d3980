#include "core/calibration/squares/umbmark.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

Vector<Robot> centreOf(const std::vector<Vector<Robot>>& errors) {
    Vector<Robot> sum;
    for (const Vector<Robot>& error : errors) sum = sum + error;
    return 1.0 / static_cast<double>(errors.size()) * sum;
}

}  // namespace

VehicleGeometry correctedGeometry(const VehicleGeometry& believed, double diameter_ratio,
                                  double wheelbase_ratio) {
    const double sum_m = believed.left_wheel_diameter_m + believed.right_wheel_diameter_m;
    const double ratio =
        diameter_ratio * believed.right_wheel_diameter_m / believed.left_wheel_diameter_m;
    VehicleGeometry geometry = believed;
    geometry.left_wheel_diameter_m = sum_m / (ratio + 1.0);
    geometry.right_wheel_diameter_m = sum_m / (1.0 / ratio + 1.0);
    geometry.wheelbase_m *= wheelbase_ratio;
    return geometry;
}

Result<UmbmarkFit> fitUmbmark(const UmbmarkReturns& returns, double side_m,
                              const VehicleGeometry& believed) {
    assert(side_m > 0.0);
    if (returns.clockwise.empty()) return fail(ErrorCode::kNoData, "clockwise squares");
    if (returns.counter_clockwise.empty()) {
        return fail(ErrorCode::kNoData, "counter-clockwise squares");
    }
    UmbmarkFit fit;
    fit.clockwise_centre = centreOf(returns.clockwise);
    fit.counter_clockwise_centre = centreOf(returns.counter_clockwise);
    fit.largest_systematic_error_m =
        std::max(fit.clockwise_centre.length(), fit.counter_clockwise_centre.length());
    fit.alpha_rad = (fit.clockwise_centre.x + fit.counter_clockwise_centre.x) / (-4.0 * side_m);
    fit.beta_rad = (fit.clockwise_centre.x - fit.counter_clockwise_centre.x) / (-4.0 * side_m);
    // E_d = (R + b/2) / (R - b/2) with R = (L/2) / sin(beta/2), without R: it is infinite where the
    // wheels are equal.
    const double bend_m = believed.wheelbase_m * std::sin(0.5 * fit.beta_rad);
    const bool small = std::abs(fit.alpha_rad) < 0.25 * kPi && std::abs(fit.beta_rad) < 0.5 * kPi &&
                       std::abs(bend_m) < 0.5 * side_m;
    if (!small) {
        return fail(ErrorCode::kBadValue, "return position errors",
                    "are too large for squares of this size");
    }
    fit.diameter_ratio = (side_m + bend_m) / (side_m - bend_m);
    fit.wheelbase_ratio = 0.5 * kPi / (0.5 * kPi - fit.alpha_rad);
    fit.corrected = correctedGeometry(believed, fit.diameter_ratio, fit.wheelbase_ratio);
    return fit;
}

}  // namespace hedr
