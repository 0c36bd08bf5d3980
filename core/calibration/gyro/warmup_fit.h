#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/robot/vehicle.h"

namespace hedr {

// The mean rate of a standing gyro over a block of time, t seconds after it was switched on.
struct WarmupBlock {
    double begin_s = 0.0;
    double end_s = 0.0;
    double mean_rad_s = 0.0;
    double heard_s = 0.0;  // time that readings speak for

    double span_s() const { return end_s - begin_s; }
    double middle_s() const { return 0.5 * (begin_s + end_s); }
};

double biasAt(const GyroDrift& curve, double t_s);
double meanBias(const WarmupBlock& block, const GyroDrift& curve);

// Of the room meanwhile. One that may change makes the bias drift steadily besides: the record has
// to tell it from the curve, and takes longer for that.
enum class RoomTemperature : std::uint8_t { kSteady, kMayChange };

// C1 (1 - exp(-t / T)) + C2 as it was found, errors as of white noise.
struct WarmupFit {
    RoomTemperature room = RoomTemperature::kSteady;
    GyroDrift curve{};
    double room_drift_rad_s2 = 0.0;  // besides the curve; 0 in a steady room
    // Of C1, C2, ln T and the room's drift, which is sure in a steady room.
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
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

// d mean bias / d (C1, C2, ln T and, where the room may change, its drift), a row for each block.
Eigen::MatrixXd warmupJacobian(std::span<const WarmupBlock> blocks, const GyroDrift& curve,
                               RoomTemperature room = RoomTemperature::kSteady);

}  // namespace hedr
