#pragma once

#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// The horizontal field as the robot would have it without iron of its own, the usual strength 1.
struct LevelField {
    double ahead = 0.0;
    double left = 0.0;

    double strength() const;
    // The robot's heading but for a constant, counter-clockwise, in [-pi, pi].
    double heading_rad() const;
};

// Undoes hard and soft iron: the ellipse of `range` becomes the circle of radius 1.
LevelField withoutIron(const MagneticField& field, const MagnetometerRange& range);

}  // namespace hedr
