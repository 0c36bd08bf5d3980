#pragma once

#include <cstdint>
#include <vector>

#include "core/calibration/sample_set.h"
#include "core/calibration/squares/umbmark_ends.h"
#include "core/robot/vehicle.h"
#include "core/simulation/random.h"

namespace hedr {

// A LabMate with wrong wheels drives squares; where they end is measured with a tape.
struct SquareDrives {
    double diameter_ratio = 1.002;  // E_d, real over believed
    double wheelbase_ratio = 1.005;
    int clockwise = 5;
    int counter_clockwise = 5;
    bool in_turns = true;  // or all clockwise ones first
    double side_m = 4.0;
    double unevenness_m_sqrtm = 1e-4;  // rms error of a wheel's travel after one metre
    double tape_m = 0.005;             // rms error of x and of y
    bool along_tape = false;           // driven by eye along a square, not by its own odometry
    double slip_share = 0.0;           // of the way on which a wheel slips
    double slip = 0.05;                // what it then loses
    double pause_s = 5.0;
};

inline constexpr VehicleGeometry kLabmate{0.150, 0.150, 0.340, 2000.0};

Vehicle labmate();
VehicleGeometry realWheels(const SquareDrives& drives);

struct DrivenSquares {
    std::vector<SampleSet> sets{};
    std::vector<UmbmarkEnd> ends{};
};

DrivenSquares drive(const SquareDrives& drives, Random& random);

// E_max,syst of wheels that are believed so, on a floor without a flaw.
double returnError_m(const VehicleGeometry& believed, const VehicleGeometry& real, double side_m);

}  // namespace hedr
