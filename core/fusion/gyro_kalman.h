#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/fusion/pose_covariance.h"
#include "core/fusion/sensor_noise.h"
#include "core/geometry/angle.h"
#include "core/robot/motion.h"

namespace hedr {

struct GyroKalmanConfig {
    GyroDrift drift{};
    std::optional<double> known_bias_rad_s{};  // none: as measured while standing at the start
    // sigma_w of the paper: 0.2 degrees per second in samples of 30 ms.
    double rate_noise_rad_s_sqrthz = radFromDeg(0.035);
    double bias_walk_rad_s_sqrts = radFromDeg(0.0003);  // what the curve does not tell
    // sigma_u of the paper, 0.05 degrees there: its vehicle of 19 t cannot turn at once, a small
    // robot does.
    double jerk_walk_rad_s3_sqrts = radFromDeg(1e5);
    WheelNoise wheels{};
};

GyroKalmanConfig gyroKalmanPreset(const Vehicle& vehicle);

// Barshan, Durrant-Whyte, "Orientation Estimate for Mobile Robots using Gyroscopic Information",
// IROS 1994: a Kalman filter over the true rotation and the error of the gyro, which is known to
// drift as C1 (1 - exp(-t / T)) + C2 while it warms up.
class GyroKalman {
  public:
    GyroKalman(const Pose<World>& start, const GyroKalmanConfig& config);

    void update(const Motion& motion);
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return state_[kBias]; }
    Eigen::Matrix3d covariance() const { return pose_covariance_.matrix(); }

  private:
    // Eq. (4): the rotation since the start with its derivatives, the error of the gyro's angle and
    // of its rate.
    enum State { kAngle, kRate, kAcceleration, kJerk, kAngleError, kBias, kStates };
    using StateVector = Eigen::Matrix<double, kStates, 1>;
    using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

    // What depends on the time step alone.
    struct Step {
        double dt_s = 0.0;
        Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
        Eigen::Matrix4d motion_noise = Eigen::Matrix4d::Zero();
        Eigen::Matrix2d error = Eigen::Matrix2d::Identity();
        Eigen::Matrix2d error_noise = Eigen::Matrix2d::Zero();
        double warm_angle_s = 0.0;   // share of the warm gyro's bias that comes to the angle
        double warm_share = 0.0;     // and to the bias
        double rate_variance = 0.0;  // of the rate as it is observed
    };

    Step stepOf(double dt_s) const;
    void beginWith(double mean_bias_rad_s, double measured_s);
    void predict();
    void correct(State motion, State error, double observed, double variance);
    void bridge(const Motion& motion);
    void hear(double sensed_rad);
    void follow(double distance_m);
    double biasAfter(double dt_s) const;

    GyroKalmanConfig config_;
    Pose<World> pose_;
    double start_heading_rad_;
    StateVector state_ = StateVector::Zero();
    StateMatrix covariance_ = StateMatrix::Zero();
    Step step_{};
    PoseCovariance pose_covariance_{};
    double warm_bias_rad_s_ = 0.0;   // where the bias goes to
    double sensed_angle_rad_ = 0.0;  // the gyro's rate, integrated
    double measured_s_ = 0.0;        // how long the bias was measured
};

}  // namespace hedr
