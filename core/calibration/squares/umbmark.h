#pragma once

#include <vector>

#include "core/geometry/frames.h"
#include "core/result.h"
#include "core/robot/vehicle.h"

namespace hedr {

// Where square drives ended: true minus computed end position of each, in the axes of its own start
// (x along the first side, y to the left of it).
struct UmbmarkReturns {
    std::vector<Vector<Robot>> clockwise;
    std::vector<Vector<Robot>> counter_clockwise;
};

struct UmbmarkFit {
    Vector<Robot> clockwise_centre{};  // of gravity
    Vector<Robot> counter_clockwise_centre{};
    double alpha_rad = 0.0;                   // too little turning at each corner
    double beta_rad = 0.0;                    // turning to the left along each side
    double diameter_ratio = 1.0;              // E_d, right wheel over left, real over believed
    double wheelbase_ratio = 1.0;             // E_b, real over believed
    double largest_systematic_error_m = 0.0;  // E_max,syst
    VehicleGeometry corrected{};
};

// Borenstein, Feng, "Measurement and Correction of Systematic Odometry Errors in Mobile Robots",
// IEEE Transactions on Robotics and Automation 12(6), 1996: the closed form, for small angles.
// Errors: kNoData (a direction was not driven), kBadValue (errors larger than the method can tell).
Result<UmbmarkFit> fitUmbmark(const UmbmarkReturns& returns, double side_m,
                              const VehicleGeometry& believed);

// The geometry with these ratios of real over believed: right wheel's diameter over left one's,
// wheelbase. The mean of the diameters stays.
VehicleGeometry correctedGeometry(const VehicleGeometry& believed, double diameter_ratio,
                                  double wheelbase_ratio);

}  // namespace hedr
