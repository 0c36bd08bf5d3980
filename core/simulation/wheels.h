#pragma once

#include "core/robot/report.h"
#include "core/robot/vehicle.h"
#include "core/simulation/random.h"

namespace hedr {

// What encoders count, rounded down, when wheels of this size have rolled so far.
WheelTicks wheelCounts(const VehicleGeometry& wheels, double left_m, double right_m);

// Two wheels on a floor that is not quite even: each rolls a little more or less than it gets on.
class Wheels {
  public:
    // `unevenness_m_sqrtm`: rms error of a wheel's travel after one metre; it grows with the root.
    Wheels(const VehicleGeometry& real, double unevenness_m_sqrtm)
        : real_(real), unevenness_m_sqrtm_(unevenness_m_sqrtm) {}

    // The robot's centre moves on by that.
    void move(double distance_m, double turn_rad, Random& random);
    WheelTicks ticks() const { return wheelCounts(real_, left_m_, right_m_); }

  private:
    double rolled(double way_m, Random& random) const;

    VehicleGeometry real_;
    double unevenness_m_sqrtm_;
    double left_m_ = 0.0;
    double right_m_ = 0.0;
};

}  // namespace hedr
