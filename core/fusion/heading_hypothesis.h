#pragma once

#include <Eigen/Core>

#include "core/fusion/driving_model.h"
#include "core/fusion/motion_segment.h"
#include "core/geometry/frames.h"

namespace hedr {

// One belief about a robot in a building of few directions: a Gaussian over position, heading, the
// heading sensor's errors and the building's direction, and over the leg that it drives.
//
// A leg is the straight stretch between two turns. While it lasts, the heading relative to the
// leg's direction is a stationary process: the driver snakes (Ornstein-Uhlenbeck along the way)
// and keeps near the middle of a corridor. What is measured is what this process does not predict,
// so that correlated zigzag is not counted as independent samples.
class HeadingHypothesis {
  public:
    enum State {
        kX,
        kY,
        kHeading,
        kBias,
        kScale,
        kCurvature,
        kGrid,
        kLeg,
        kLateral,
        kWitnessScale,
        kWitnessCurvature,
        kTurnError,  // of the last segment; it is in the heading, too
        kStates
    };
    using StateVector = Eigen::Matrix<double, kStates, 1>;
    using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

    // The building's direction is that of the start, with this standard deviation.
    HeadingHypothesis(const Pose<World>& start, double grid_sigma_rad, double bias_rad_s,
                      const DrivingModel& model);

    void move(const MotionSegment& segment, const DrivingModel& model);
    // Something happened to the heading that is not in the model.
    void loosen(double sigma_rad);
    // What was believed of the building's direction may be wrong.
    void loosenGrid(double sigma_rad);

    // The six below measure, and return the logarithm of the measurement's likelihood.

    // The encoders tell the turn, too; `noise_rad2_s` is the density of their noise. A slipping
    // wheel is a surprise and counts little.
    double hearWitness(const MotionSegment& segment, double noise_rad2_s,
                       const DrivingModel& model);
    double standStill(const MotionSegment& segment, const DrivingModel& model);
    // A plan tells the building's direction, which is the same after every quarter turn.
    double hearDirection(double direction_rad, double sigma_rad);
    // Begins a leg along the building's direction plus `offset_rad`.
    double beginLegAlong(double offset_rad, const DrivingModel& model);
    double driveLegAlong(const MotionSegment& segment, const DrivingModel& model);
    // A leg of its own direction walks at random by `wander_rad_sqrtm`, and has no middle to keep
    // to.
    double driveFreeLeg(const MotionSegment& segment, double wander_rad_sqrtm,
                        const DrivingModel& model);

    // Begins a leg that has a direction of its own.
    void beginFreeLeg(const DrivingModel& model);

    Pose<World> pose() const { return {{mean_[kX], mean_[kY]}, mean_[kHeading]}; }
    double heading_rad() const { return mean_[kHeading]; }
    double fromGrid_rad() const { return mean_[kHeading] - mean_[kGrid]; }
    double fromGridVariance() const;
    double biasWalk_rad_s_sqrts() const { return bias_walk_rad_s_sqrts_; }

    const StateVector& mean() const { return mean_; }
    const StateMatrix& covariance() const { return covariance_; }

    // Moment-preserving merge, with shares that add up to 1.
    void absorb(const HeadingHypothesis& other, double own_share);
    // The building looks the same after this turn.
    void turnGrid(double rad) { mean_[kGrid] += rad; }

  private:
    struct Measurement {
        StateVector row = StateVector::Zero();
        double innovation = 0.0;
        double variance = 0.0;
        double surprise = 1e9;  // Huber: beyond so many sigmas it counts linearly
        bool tells_scale = true;
    };

    double measure(const Measurement& measurement);
    Measurement unexpectedOnLeg(const MotionSegment& segment, const DrivingModel& model,
                                double steering_rad_m) const;
    void placeInMiddle(const DrivingModel& model);

    StateVector mean_ = StateVector::Zero();
    StateMatrix covariance_ = StateMatrix::Zero();
    double bias_walk_rad_s_sqrts_;
};

}  // namespace hedr
