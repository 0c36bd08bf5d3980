#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/calibration/gyro/warmup_curve.h"

namespace hedr {

// C1, C2, ln T and, where the room may change, its drift, of time since the record began: of a gyro
// that was on for long before, C1 and C2 since then are far from what was seen, and hide each
// other.
using WarmupParameters = Eigen::VectorXd;

double roomDriftOf(const WarmupParameters& parameters);  // 0 in a steady room

// The blocks as a problem of least squares in which all rows are equally sure.
class WarmupProblem {
  public:
    WarmupProblem(std::span<const WarmupBlock> blocks, RoomTemperature room);

    Eigen::Index rows() const { return static_cast<Eigen::Index>(blocks_.size()); }
    Eigen::Index parameters() const { return warmupParametersIn(room_); }
    double degreesOfFreedom() const { return static_cast<double>(rows() - parameters()); }
    // Bounds of T: beyond them nothing bends, or all is over at once.
    double shortest_s() const;
    double longest_s() const;

    // Of time since it was switched on, and back.
    GyroDrift curve(const WarmupParameters& parameters) const;
    WarmupParameters parametersFor(const GyroDrift& curve, double room_drift_rad_s2) const;
    // d (C1, C2, ln T, drift) since it was switched on / d parameters
    Eigen::MatrixXd sinceSwitchedOn(const WarmupParameters& parameters) const;

    WarmupParameters withoutWarmup(double log_time) const;  // and without bias
    // The best of all others for a T.
    WarmupParameters bestFor(double time_s) const;

    Eigen::VectorXd residuals(const WarmupParameters& parameters) const;
    Eigen::MatrixXd jacobian(const WarmupParameters& parameters) const;
    Eigen::MatrixXd weighted(const Eigen::MatrixXd& columns) const;

  private:
    const WarmupBlock& block(Eigen::Index i) const { return blocks_[static_cast<std::size_t>(i)]; }

    double on_before_s_;
    std::vector<WarmupBlock> blocks_;  // since the record began
    RoomTemperature room_;
    Eigen::VectorXd root_weights_;
};

}  // namespace hedr
