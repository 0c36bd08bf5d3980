#include "core/fusion/gh_filter.h"

#include "core/fusion/dead_reckoning.h"
#include "core/geometry/angle.h"

namespace hedr {

GhFilter::GhFilter(const Pose<World>& start, GhHeading heading, const GhConfig& config)
    : heading_(heading),
      config_(config),
      alpha_(config.alpha),
      beta_(config.beta),
      compass_(start.heading_rad, config.magnetometer),
      pose_(start),
      gyro_heading_rad_(start.heading_rad),
      by_gyro_(config.gyro.bias_rad2_s2()) {
    if (heading != GhHeading::kCombined) config_.gamma = heading == GhHeading::kGyro ? 1.0 : 0.0;
}

void GhFilter::update(const Motion& motion) {
    // Where the wheels are not told apart, the gyro predicts.
    const double turn_rad = motion.odometry_turn_rad.value_or(motion.gyro_turn_rad.value_or(0.0));
    // Eq. (5). Differs from the paper: what is added is the difference, else the rate only grows.
    rate_rad_s_ += beta_.over(motion.dt_s) * (turn_rad / motion.dt_s - rate_rad_s_);
    double heading_rad = pose_.heading_rad + rate_rad_s_ * motion.dt_s;
    unsensed_s_ += motion.dt_s;
    if (const auto sensed_rad = sensedHeading(motion, turn_rad)) {
        // Eq. (6). Differs from the paper: a heading corrects a heading, on the circle.
        heading_rad += alpha_.over(unsensed_s_) * wrapAngle(*sensed_rad - heading_rad);
        unsensed_s_ = 0.0;
    }
    const Point<World> before = pose_.position;
    pose_ = advanced(pose_, motion.distance_m, heading_rad - pose_.heading_rad);
    spread(motion, pose_.position - before, turn_rad);
    bias_rad_s_ = motion.gyro_bias_rad_s;
}

std::optional<double> GhFilter::sensedHeading(const Motion& motion, double turn_rad) {
    gyro_heading_rad_ += motion.gyro_turn_rad.value_or(0.0);
    if (heading_ == GhHeading::kGyro) return gyro_heading_rad_;
    const auto magnetic_rad = compass_.heading(motion, pose_.heading_rad + turn_rad);
    if (heading_ == GhHeading::kMagnetometer || !magnetic_rad) return magnetic_rad;
    // Eq. (8). Differs from the paper: on the circle.
    return *magnetic_rad + config_.gamma * wrapAngle(gyro_heading_rad_ - *magnetic_rad);
}

void GhFilter::spread(const Motion& motion, Vector<World> way, double turn_rad) {
    const WheelNoise& wheels = config_.wheels;
    by_wheels_.move(
        way,
        {.along_m2 = wheels.along_m2(motion.distance_m, turn_rad),
         .turn_rad2 = config_.alpha > 0.0 ? 0.0 : wheels.turn_rad2(motion.distance_m, turn_rad)});
    by_gyro_.move(
        way, {.turn_rad2 = config_.gyro.turn_rad2(motion.dt_s, motion.gyro_turn_rad.value_or(0.0)),
              .drift_share = motion.dt_s,
              .drift_variance = config_.gyro.biasWalk_rad2_s2(motion.dt_s)});
    const double kept = config_.magnetic.kept(motion.distance_m);
    by_field_.move(way, {.turn_rad2 = config_.magnetic.turn_rad2(kept), .heading_kept = kept});
}

// However small alpha is, in the long run the heading is the sensed one; without it, the wheels'.
Eigen::Matrix3d GhFilter::covariance() const {
    if (config_.alpha == 0.0) return by_wheels_.matrix();
    const double gamma = config_.gamma;
    return by_wheels_.matrix() + gamma * gamma * by_gyro_.matrix() +
           (1.0 - gamma) * (1.0 - gamma) * by_field_.matrix();
}

}  // namespace hedr
