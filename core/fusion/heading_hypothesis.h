#pragma once

#include <Eigen/Core>

#include "core/fusion/motion_segment.h"
#include "core/geometry/angle.h"
#include "core/geometry/frames.h"

namespace hedr {

// How the robot, its heading sensor and its driver behave. One set per kind of heading sensor.
struct DrivingModel {
    bool turn_from_encoders = false;
    double turn_noise_rad_sqrts = radFromDeg(0.05);  // angle random walk
    double turn_noise_rad_sqrtm = 0.0;               // the same per way, for encoders
    double bias_rad_s = radFromDeg(0.5);             // how large it may be at the start
    double bias_walk_rad_s_sqrts = radFromDeg(0.006);
    double turn_noise_rad_sqrtrad = 0.0;            // the same per turn, for encoders
    double scale = 0.01;                            // share of a turn
    double curvature_rad_m = 0.0;                   // turn per way of unequal wheels
    double curvature_walk_rad_m_sqrtm = 0.0;        // and how it changes
    double slip_sqrtm = 0.03;                       // m of way per sqrt(m)
    double zigzag_rad = radFromDeg(3.0);            // rms of a driver's snaking
    double zigzag_m = 1.5;                          // its correlation length
    double lateral_m = 0.15;                        // rms, off the middle of a corridor
    double crooked_corridor_rad = radFromDeg(0.3);  // of a corridor against the building
};

// One belief about a robot in a building of few directions: a Gaussian over position, heading, the
// heading sensor's errors and the building's direction, and over the leg that it drives.
//
// A leg is the straight stretch between two turns. While it lasts, the heading relative to the
// leg's direction is a stationary process: the driver snakes (Ornstein-Uhlenbeck along the way)
// and keeps near the middle of a corridor. What is measured is what this process does not predict,
// so that correlated zigzag is not counted as independent samples.
class HeadingHypothesis {
  public:
    enum State { kX, kY, kHeading, kBias, kScale, kCurvature, kGrid, kLeg, kLateral, kStates };
    using StateVector = Eigen::Matrix<double, kStates, 1>;
    using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

    // The building's direction is that of the start, with this standard deviation.
    HeadingHypothesis(const Pose<World>& start, double grid_sigma_rad, double bias_rad_s,
                      const DrivingModel& model);

    void move(const MotionSegment& segment, const DrivingModel& model);
    // A gap in what is known of the heading.
    void loosen(double sigma_rad);

    // The three below measure, and return the logarithm of the measurement's likelihood.
    double standStill(const MotionSegment& segment, const DrivingModel& model);
    // Begins a leg along the building's direction plus `offset_rad`.
    double beginLegAlong(double offset_rad, const DrivingModel& model);
    // `trusts_straightness`: false measures how well the leg is kept, and learns nothing else of
    // it.
    double driveLeg(const MotionSegment& segment, const DrivingModel& model,
                    bool trusts_straightness);
    // Begins a leg that has a direction of its own.
    void beginFreeLeg(const DrivingModel& model);

    Pose<World> pose() const { return {{mean_[kX], mean_[kY]}, mean_[kHeading]}; }
    double heading_rad() const { return mean_[kHeading]; }
    double fromGrid_rad() const { return mean_[kHeading] - mean_[kGrid]; }
    double fromGridVariance() const;

    const StateVector& mean() const { return mean_; }
    const StateMatrix& covariance() const { return covariance_; }

    // Moment-preserving merge, with shares that add up to 1.
    void absorb(const HeadingHypothesis& other, double own_share);
    // The building looks the same after this turn.
    void turnGrid(double rad) { mean_[kGrid] += rad; }

  private:
    enum class Learns { kAll, kAllButScale, kLegOnly };

    double measure(const StateVector& row, double innovation, double variance, Learns learns);

    StateVector mean_ = StateVector::Zero();
    StateMatrix covariance_ = StateMatrix::Zero();
};

}  // namespace hedr
