#pragma once

#include <optional>
#include <string>

#include "core/calibration/compass/ellipse_fit.h"
#include "core/calibration/compass/ellipsoid_fit.h"
#include "core/calibration/compass/magnetic_turns.h"

namespace hedr {

// How good a record of a field is, as shares: the four figures that compass calibrations of
// telephones judge by, here with what they mean for turns on the spot.
struct FieldQuality {
    double gaps = 1.0;               // of the circle, where no reading is
    double variance = 0.0;           // standard deviation of the strength over its mean
    std::optional<double> wobble{};  // unsteadiness of the vertical component over the radius;
                                     // none: it is not told
    double tilt_error = 0.0;  // what that unsteadiness does to the level field, over the radius
    double fit_error = 0.0;   // root mean square distance from the ellipse over its radius
    double outliers = 0.0;    // readings left out; the others have no share of them

    // What is beyond its limit and what to do, one sentence; empty: nothing.
    std::string complaint() const;

    static constexpr double kMostGaps = 0.15;
    static constexpr double kMostVariance = 0.045;
    static constexpr double kMostWobble = 0.04;
    static constexpr double kMostFitError = 0.05;
    static constexpr double kMostOutliers = 0.1;
};

// Of the vertical component only what does not go with the heading once or twice a turn counts: a
// sensor that sits askew on the robot does no harm.
FieldQuality fieldQualityOf(const MagneticTurns& turns, const EllipseFit& fit);
FieldQuality fieldQualityOf(const EllipsoidFit& fit);

}  // namespace hedr
