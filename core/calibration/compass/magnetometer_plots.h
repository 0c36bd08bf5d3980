#pragma once

#include <vector>

#include "core/calibration/compass/magnetometer.h"
#include "core/calibration/evidence.h"

namespace hedr {

// The horizontal field with the ellipse, and the compass before and after against the heading: by
// the judge, or, where there is none, the field's strength.
std::vector<EvidencePlot> plotsOfTurns(const MagnetometerTurns& level,
                                       const MagnetometerRange& believed);

// The field of a sensor that was turned through all directions, seen from above, as it is and
// without iron.
std::vector<EvidencePlot> plotsOfSphere(const EllipsoidFit& sphere,
                                        const std::vector<Eigen::Vector3d>& field);

}  // namespace hedr
