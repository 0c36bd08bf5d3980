#include "core/fusion/gyro_kalman.h"

#include <algorithm>
#include <cmath>

#include "core/fusion/dead_reckoning.h"

namespace hedr {

namespace {

constexpr double kLongestGap_s = 2.0;  // nobody watched the gyro for longer
constexpr double kLongestStep_s = 0.5;
constexpr double kGapDrift_rad_s = radFromDeg(1.0);
constexpr double kMostGapDrift_rad = radFromDeg(30.0);
constexpr double kAngleNoise_rad = 1e-5;
constexpr double kUnmeasuredBias_rad_s = radFromDeg(0.05);
constexpr double kNoiseBand = 3.0;  // standard deviations of the measured bias that say nothing

double squared(double value) { return value * value; }

// x / (exp(x) - 1)
double bernoulli(double x) { return x < 1e-9 ? 1.0 : x / std::expm1(x); }

}  // namespace

GyroKalmanConfig gyroKalmanPreset(const Vehicle& vehicle) {
    GyroKalmanConfig config{.drift = vehicle.gyro_drift.value_or(GyroDrift{}),
                            .known_bias_rad_s = vehicle.gyro_bias_rad_s,
                            .wheels = wheelNoiseOf(vehicle)};
    if (vehicle.gyro_noise_rad_s_sqrthz > 0.0)
        config.rate_noise_rad_s_sqrthz = vehicle.gyro_noise_rad_s_sqrthz;
    if (vehicle.gyro_bias_walk_rad_s_sqrts > 0.0)
        config.bias_walk_rad_s_sqrts = vehicle.gyro_bias_walk_rad_s_sqrts;
    return config;
}

GyroKalman::GyroKalman(const Pose<World>& start, const GyroKalmanConfig& config)
    : config_(config), pose_(start), start_heading_rad_(start.heading_rad) {
    beginWith(config.known_bias_rad_s.value_or(config.drift.c2_rad_s), 0.0);
}

// The bias that was measured says where on its curve the gyro is, however long it has been on; what
// lies off the curve by more than the measurement's noise is an offset that stays.
// Differs from the paper: it has no offset, and takes the mean for the bias at the end of the
// measurement.
void GyroKalman::beginWith(double mean_bias_rad_s, double measured_s) {
    const GyroDrift& drift = config_.drift;
    const double x = measured_s / drift.time_s;
    const double shortest = x < 1e-9 ? 1.0 : -std::expm1(-x) / x;  // of the way from C2, averaged
    const double warm = drift.c1_rad_s + drift.c2_rad_s;
    const auto [low, high] = std::minmax({warm - drift.c1_rad_s * shortest, warm});
    const double on_curve = std::clamp(mean_bias_rad_s, low, high);
    const double off_curve = mean_bias_rad_s - on_curve;
    const double noise =
        measured_s > 0.0 ? config_.rate_noise_rad_s_sqrthz / std::sqrt(measured_s) : 0.0;
    warm_bias_rad_s_ =
        warm + off_curve - std::clamp(off_curve, -kNoiseBand * noise, kNoiseBand * noise);
    state_.setZero();
    // The mean of the time measured_s, led on to its end.
    state_[kBias] = warm_bias_rad_s_ + (on_curve - warm) * bernoulli(x);
    covariance_.setZero();
    covariance_(kBias, kBias) = measured_s > 0.0
                                    ? squared(config_.rate_noise_rad_s_sqrthz) / measured_s
                                    : squared(kUnmeasuredBias_rad_s);
    sensed_angle_rad_ = 0.0;
}

void GyroKalman::update(const Motion& motion) {
    if (motion.bias_measured_s > measured_s_) {
        measured_s_ = motion.bias_measured_s;
        beginWith(motion.gyro_bias_rad_s, measured_s_);
        return;  // it has not moved yet
    }
    const bool unwatched = motion.dt_s > kLongestGap_s || motion.gyro_silent;
    if (unwatched || !motion.gyro_turn_rad) return bridge(motion);
    // The model's jerk is good for short steps only.
    const double pieces = std::ceil(motion.dt_s / kLongestStep_s);
    const double dt_s = motion.dt_s / pieces;
    const double sensed_rad = *motion.gyro_turn_rad / pieces + motion.gyro_bias_rad_s * dt_s;
    if (dt_s != step_.dt_s) step_ = stepOf(dt_s);
    for (double piece = 0.0; piece < pieces; piece += 1.0) hear(sensed_rad);
    follow(motion.distance_m);
}

void GyroKalman::hear(double sensed_rad) {
    sensed_angle_rad_ += sensed_rad;
    predict();
    // Eqs. (4), (5): the first observation is the integral of the second.
    correct(kAngle, kAngleError, sensed_angle_rad_, squared(kAngleNoise_rad));
    correct(kRate, kBias, sensed_rad / step_.dt_s, step_.rate_variance);
}

void GyroKalman::follow(double distance_m) {
    const double heading_rad = start_heading_rad_ + state_[kAngle];
    const Point<World> before = pose_.position;
    pose_ = advanced(pose_, distance_m, heading_rad - pose_.heading_rad);
    const double grown_rad2 = covariance_(kAngle, kAngle) - pose_covariance_.heading_rad2();
    pose_covariance_.move(pose_.position - before,
                          {.along_m2 = config_.wheels.along_m2(distance_m, 0.0),
                           .turn_rad2 = std::max(grown_rad2, 0.0)});
}

// Over time that the gyro did not see, the heading turns as the motion says, and the filter starts
// again from there.
void GyroKalman::bridge(const Motion& motion) {
    const double turn_rad = motion.gyro_turn_rad.value_or(motion.odometry_turn_rad.value_or(0.0));
    const double angle_rad = state_[kAngle] + turn_rad;
    const double angle_variance =
        covariance_(kAngle, kAngle) +
        squared(std::min(kGapDrift_rad_s * motion.dt_s, kMostGapDrift_rad));
    const double bias_variance =
        covariance_(kBias, kBias) + squared(config_.bias_walk_rad_s_sqrts) * motion.dt_s;
    const double bias_rad_s = biasAfter(motion.dt_s);
    state_.setZero();
    state_[kAngle] = sensed_angle_rad_ = angle_rad;
    state_[kBias] = bias_rad_s;
    covariance_.setZero();
    // The sum of the two is known: it is what is observed.
    covariance_(kAngle, kAngle) = covariance_(kAngleError, kAngleError) = angle_variance;
    covariance_(kAngle, kAngleError) = covariance_(kAngleError, kAngle) = -angle_variance;
    covariance_(kBias, kBias) = bias_variance;
    follow(motion.distance_m);
}

double GyroKalman::biasAfter(double dt_s) const {
    return warm_bias_rad_s_ +
           (state_[kBias] - warm_bias_rad_s_) * std::exp(-dt_s / config_.drift.time_s);
}

GyroKalman::Step GyroKalman::stepOf(double dt_s) const {
    Step step;
    step.dt_s = dt_s;
    const double t = dt_s;
    // Eq. (6)
    step.motion << 1.0, t, t * t / 2.0, t * t * t / 6.0,  //
        0.0, 1.0, t, t * t / 2.0,                         //
        0.0, 0.0, 1.0, t,                                 //
        0.0, 0.0, 0.0, 1.0;
    // Differs from the paper: its T_s and T_1 / (T_1 + T_s) are of first order in T_s / T_1.
    const double cooling = -std::expm1(-t / config_.drift.time_s);
    step.error << 1.0, config_.drift.time_s * cooling,  //
        0.0, 1.0 - cooling;
    step.warm_angle_s = t - config_.drift.time_s * cooling;
    step.warm_share = cooling;
    // Eq. (8)
    const double t2 = t * t, t3 = t2 * t, t4 = t2 * t2, t5 = t4 * t, t6 = t3 * t3, t7 = t6 * t;
    step.motion_noise << t7 / 252.0, t6 / 72.0, t5 / 30.0, t4 / 24.0,  //
        t6 / 72.0, t5 / 20.0, t4 / 8.0, t3 / 6.0,                      //
        t5 / 30.0, t4 / 8.0, t3 / 3.0, t2 / 2.0,                       //
        t4 / 24.0, t3 / 6.0, t2 / 2.0, t;
    step.motion_noise *= squared(config_.jerk_walk_rad_s3_sqrts);
    step.error_noise << t3 / 3.0, t2 / 2.0,  //
        t2 / 2.0, t;
    // Differs from the paper: sigma_w is the white noise of the rate, so it belongs to the
    // observation; as a walk of the bias it would take quick turns for drift.
    step.error_noise *= squared(config_.bias_walk_rad_s_sqrts);
    // What the first observation sums up of that noise is an error of the angle.
    step.error_noise(0, 0) += squared(config_.rate_noise_rad_s_sqrthz) * t;
    step.rate_variance = squared(config_.rate_noise_rad_s_sqrthz) / t;
    return step;
}

void GyroKalman::predict() {
    // Eq. (7), by the blocks of F: motion and error touch only where they are observed.
    state_.head<4>() = step_.motion * state_.head<4>();
    state_.tail<2>() = step_.error * state_.tail<2>();
    state_[kAngleError] += step_.warm_angle_s * warm_bias_rad_s_;
    state_[kBias] += step_.warm_share * warm_bias_rad_s_;
    const Eigen::Matrix4d motion =
        step_.motion * covariance_.topLeftCorner<4, 4>() * step_.motion.transpose();
    const Eigen::Matrix<double, 4, 2> cross =
        step_.motion * covariance_.topRightCorner<4, 2>() * step_.error.transpose();
    const Eigen::Matrix2d error =
        step_.error * covariance_.bottomRightCorner<2, 2>() * step_.error.transpose();
    // Rounding must not build up an asymmetry: the jerk's variance is 30 orders above the angle's.
    covariance_.topLeftCorner<4, 4>() = 0.5 * (motion + motion.transpose()) + step_.motion_noise;
    covariance_.topRightCorner<4, 2>() = cross;
    covariance_.bottomLeftCorner<2, 4>() = cross.transpose();
    covariance_.bottomRightCorner<2, 2>() = error + step_.error_noise;
}

// One observation of the sum of two states; Eq. (9).
// Differs from the paper: the error's states are led by their model alone and only considered
// (Schmidt). No observation tells drift from turning, and a filter that tries takes every quick
// turn for drift.
void GyroKalman::correct(State motion, State error, double observed, double variance) {
    const StateVector with_sum = covariance_.col(motion) + covariance_.col(error);
    const double sum_variance = with_sum[motion] + with_sum[error] + variance;
    const double innovation = observed - (state_[motion] + state_[error]);
    state_.head<4>() += with_sum.head<4>() * (innovation / sum_variance);
    const StateVector scaled = with_sum / std::sqrt(sum_variance);
    covariance_.topLeftCorner<4, 4>() -= scaled.head<4>() * scaled.head<4>().transpose();
    covariance_.topRightCorner<4, 2>() -= scaled.head<4>() * scaled.tail<2>().transpose();
    covariance_.bottomLeftCorner<2, 4>() = covariance_.topRightCorner<4, 2>().transpose();
}

}  // namespace hedr
