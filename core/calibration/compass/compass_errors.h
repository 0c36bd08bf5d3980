#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/calibration/compass/ellipse_fit.h"
#include "core/calibration/compass/magnetic_turns.h"
#include "core/calibration/proof.h"
#include "core/robot/vehicle.h"

namespace hedr {

// By how much the heading of a compass with that range is off, a constant and a steady drift of
// the judge left out: magnetic heading less the judge's, at each reading of the turns, rad.
// The judge's scale and bias are those that fit `range` best where the compass goes round as often
// as the judge does, else those that fit `reference` best.
Eigen::VectorXd headingErrors_rad(const MagneticTurns& turns, const MagnetometerRange& range,
                                  const MagnetometerRange& reference);

// By how much the strength of the field without iron differs from its mean over all readings, as a
// share of it.
Eigen::VectorXd strengthErrors(const MagneticTurns& turns, const MagnetometerRange& range);

double rmsOf(const Eigen::VectorXd& values);

// Root mean square over the circle of the heading error that a compass with `range` has where
// `truth` has none, the best constant left out, rad.
double headingErrorOverCircle_rad(const MagnetometerRange& range, const MagnetometerRange& truth);

// The same of what the errors of the fit let expect, rad.
double expectedHeadingError_rad(const EllipseFit& fit);

// Each part with the old range and with the one that the rest of the readings gives: errors of
// heading by the judge, or of strength where there is none. `signs`: those of the found ranges.
std::vector<HeldOutError> compassHeldOut(const MagneticTurns& turns, const Ellipse& all,
                                         const MagnetometerRange& old,
                                         const MagnetometerRange& signs);

// `range` with the signs of another one.
MagnetometerRange withSignsOf(MagnetometerRange range, const MagnetometerRange& signs);

}  // namespace hedr
