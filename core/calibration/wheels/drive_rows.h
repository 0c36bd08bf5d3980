#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/calibration/wheels/drive_pieces.h"

namespace hedr {

// What else is in the readings of a drive.
struct DriveNoise {
    double count_m = 0.0;            // of the encoders
    double gyro_rad_s_sqrthz = 0.0;  // angle random walk
    double rounding_rad_s = 0.0;     // of a coarse gyro, the same for a whole piece
    double bias_rad_s = 0.0;         // standard deviation of what is left of the bias at the start
    double bias_walk_rad_s_sqrts = 0.0;
    double bias_slope_rad_s2 = 0.0;  // of its steady drift, as the temperature changes; rms
};

// The pieces of one log; its gyro's bias has nothing to do with that of others.
struct DriveLog {
    std::vector<DrivePiece> pieces{};
    DriveNoise noise{};
};

// Two wheels or tracks, as the way they roll tells them from the believed ones.
struct WheelShape {
    double wheelbase_m = 0.0;  // effective: what turns by the wheels as much as by the gyro
    // How much larger the right wheel is than the left one, against what was believed, as a share
    // of their mean, which stays.
    double right_larger = 0.0;
};

// The linear model of a drive, a row for each piece:
//     right - left = wheelbase · gyro - wheelbase · bias · span - right_larger · way
// Unknown are wheelbase, right_larger, and wheelbase · bias, log by log: at knots half a minute
// apart, which walk as far as the gyro's noise lets them, and a steady drift.
class DriveRows {
  public:
    explicit DriveRows(std::span<const DriveLog> logs);

    Eigen::Index count() const { return difference_m_.size(); }
    const DrivePiece& piece(Eigen::Index row) const;
    const DriveNoise& noise(Eigen::Index row) const;
    double gyroVariance_rad2(Eigen::Index row) const;  // of the angle in it

    // Least squares with a weight (1/m²) for each row; 0: it does not count. `wheelbase_m`: as it
    // is known so far, for how much the bias may walk and what it is while the robot stands.
    Eigen::VectorXd solve(const Eigen::VectorXd& weights, double wheelbase_m) const;
    // The same where only the bias is free.
    Eigen::VectorXd solveBias(const Eigen::VectorXd& weights, const WheelShape& shape) const;

    // How unsure wheelbase and right_larger are, as the bias is: from its walk and drift, and from
    // the gyro's noise while the robot stands. Covariance.
    Eigen::Matrix2d unsureFromBias(const Eigen::VectorXd& weights, double wheelbase_m) const;

    // Per row: right - left less what the solution says.
    Eigen::VectorXd residuals_m(const Eigen::VectorXd& solution) const;
    // Per row: the gyro less its bias.
    Eigen::VectorXd turned_rad(const Eigen::VectorXd& solution) const;
    static WheelShape shapeOf(const Eigen::VectorXd& solution);

  private:
    struct Knots {  // of one log; the column after them is the drift's
        Eigen::Index first = 0;
        Eigen::Index count = 0;
        double begin_s = 0.0;
        double spacing_s = 0.0;
    };
    void addKnots(std::span<const DrivePiece> pieces);
    void addRow(Eigen::Index row, const DrivePiece& piece, const Knots& knots);
    struct Equations {
        Eigen::MatrixXd information{};  // 1/m²
        Eigen::VectorXd right_side{};
    };
    Equations equations(const Eigen::VectorXd& weights, double wheelbase_m) const;
    // The information (1/m²) that the bias' walk has, shape left out.
    Eigen::MatrixXd biasPrior(double wheelbase_m) const;

    std::vector<DrivePiece> pieces_{};
    std::vector<std::size_t> log_of_{};
    std::vector<DriveNoise> noises_{};
    std::vector<Knots> knots_{};
    Eigen::VectorXd difference_m_{};
    Eigen::MatrixXd design_{};
};

}  // namespace hedr
