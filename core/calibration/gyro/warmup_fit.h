#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/gyro/warmup_curve.h"
#include "core/robot/vehicle.h"

namespace hedr {

// C1 (1 - exp(-t / T)) + C2 as it was found, errors as of white noise.
struct WarmupFit {
    RoomTemperature room = RoomTemperature::kSteady;
    GyroDrift curve{};
    double room_drift_rad_s2 = 0.0;  // besides the curve; 0 in a steady room
    // Of C1, C2, ln T and the room's drift, which is sure in a steady room.
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    Interval time_95_s{};  // by the likelihood ratio: it may reach further up than down
    double degrees_of_freedom = 1.0;
    int iterations = 0;
    bool converged = false;
    double change_chi_squared = 0.0;  // against a gyro that does not warm up
    double slow_misfit_p = 1.0;  // chance that noise leaves as much that goes slowly to and fro
    std::vector<double> residuals_rad_s{};  // of the blocks

    Estimate c1_rad_s() const;
    Estimate c2_rad_s() const;
    Estimate time_s() const;
    Estimate room_rad_s2() const;
    Estimate bias_rad_s(double t_s) const;  // the room's drift included
    // How much larger the mean bias from t_s on over span_s is than that at t_s.
    Estimate mean_change_rad_s(double t_s, double span_s) const;
    double relativeErrorOfTime() const;  // standard
};

inline constexpr std::size_t kFewestWarmupBlocks = 20;

// Levenberg-Marquardt on the blocks' means, at least kFewestWarmupBlocks, in order, from a start
// that it finds itself.
WarmupFit fitWarmup(std::span<const WarmupBlock> blocks,
                    RoomTemperature room = RoomTemperature::kSteady);

// The same from one that is near, without errors.
WarmupFit refitWarmup(std::span<const WarmupBlock> blocks, const WarmupFit& near);

}  // namespace hedr
