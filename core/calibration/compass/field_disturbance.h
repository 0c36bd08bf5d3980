#pragma once

#include <optional>

#include "core/calibration/compass/ellipse_fit.h"
#include "core/calibration/compass/magnetic_turns.h"

namespace hedr {

// A part of the residuals that goes with heading or turn, where only noise should be.
struct FieldPattern {
    double size = 0.0;    // root mean square
    double chance = 1.0;  // that noise is so large

    bool isBeyond(double limit) const { return size > limit && chance < kSurelyNone; }
    static constexpr double kSurelyNone = 1e-4;
};

// Surroundings that are not the same field everywhere the sensor comes.
struct FieldDisturbance {
    FieldPattern shape{};  // waves of three to five per turn, as a share of the radius
    FieldPattern turns{};  // from turn to turn: size and middle of the ellipse, the same
    // Of the compass against the judge, one to four waves per turn, rad: a field that changes from
    // place to place shifts the ellipse and bends the heading, and only the judge sees it.
    std::optional<FieldPattern> heading{};

    bool isDisturbed() const {
        return shape.isBeyond(kMostShape) || turns.isBeyond(kMostTurns) ||
               (heading && heading->isBeyond(kMostHeading_rad));
    }

    static constexpr double kMostShape = 0.015;
    static constexpr double kMostTurns = 0.02;
    static constexpr double kMostHeading_rad = 0.035;  // 2°
};

// `range`: of the fit, with its signs.
FieldDisturbance disturbanceIn(const MagneticTurns& turns, const EllipseFit& fit,
                               const MagnetometerRange& range);

}  // namespace hedr
