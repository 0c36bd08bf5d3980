#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/estimate.h"
#include "core/calibration/gyro/gyro_turns.h"

namespace hedr {

// What a gyro reported of whole turns from mark to mark, and the covariance of the errors.
struct TurnModel {
    Eigen::VectorXd reported_rad{};
    Eigen::VectorXd turned_rad{};  // whole turns, counter-clockwise positive
    Eigen::MatrixXd known{};       // noise of the gyro and errors of its bias, rad²
    double known_degrees = 1.0;    // of freedom
    // Of standing beside the mark by one radian each time: neighbours share a stand.
    Eigen::MatrixXd marks{};
    double usual_mark_rad = 0.0;  // standard deviation, positive

    Eigen::MatrixXd errors() const { return known + usual_mark_rad * usual_mark_rad * marks; }
};

TurnModel turnModelOf(std::span<const TurnLog> logs, std::span<const GyroTurn> turns,
                      double usual_mark_rad);

// A turn far from the others, or the stand after it.
struct TurnOutlier {
    std::size_t turn = 0;  // of the model
    bool stand = false;    // it was put back beside the mark after that turn, and stood right again
    double off_rad = 0.0;
};

// Scales are true per reported rate.
struct TurnFit {
    std::optional<Estimate> counter_clockwise{};
    std::optional<Estimate> clockwise{};
    Estimate both{};
    std::optional<Estimate> difference{};  // counter-clockwise less clockwise, over both
    double mark_rad = 0.0;                 // standard deviation of a stand from the mark
    bool mark_was_given = false;           // too few turns to tell it from their scatter
    std::vector<TurnOutlier> outliers{};
};

// Generalised least squares with one scale for each direction. The errors are those of the model
// but for a factor that the scatter of the turns tells; where fewer than two turns are left over
// for that, it is one. The model has a turn at least.
TurnFit fitTurns(const TurnModel& model);

// The scale from all turns but one; the outliers stay known. None: the others do not tell it.
std::optional<double> scaleWithout(const TurnModel& model, const TurnFit& fit, std::size_t turn);

}  // namespace hedr
