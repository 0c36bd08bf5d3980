#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

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

// Of the room meanwhile. One that may change makes the bias drift steadily besides: the record has
// to tell it from the curve, and takes longer for that.
enum class RoomTemperature : std::uint8_t { kSteady, kMayChange };

// C1, C2, ln T and, where the room may change, its drift.
inline constexpr Eigen::Index kMostWarmupParameters = 4;
Eigen::Index warmupParametersIn(RoomTemperature room);

// C1 (1 - exp(-t / T)) + C2, at a time and over a block.
double biasAt(const GyroDrift& curve, double t_s);
double meanBias(const WarmupBlock& block, const GyroDrift& curve);

// d mean bias / d (C1, C2, ln T and, where the room may change, its drift), a row for each block.
Eigen::MatrixXd warmupJacobian(std::span<const WarmupBlock> blocks, const GyroDrift& curve,
                               RoomTemperature room = RoomTemperature::kSteady);

}  // namespace hedr
