#include "core/fusion/hedr.h"

#include <algorithm>
#include <cmath>

#include "core/fusion/dead_reckoning.h"

namespace hedr {

namespace {

constexpr double kRateFilter_s = 0.3;
constexpr double kLockMemory_m = 10.0;
constexpr double kLostShare = 0.125;      // of the interval
constexpr double kLongestLesson_s = 5.0;  // what was driven over a longer gap, nobody saw

double yawTurn(const Motion& motion, HeadingSource source) {
    const auto& wanted =
        source == HeadingSource::kGyro ? motion.gyro_turn_rad : motion.odometry_turn_rad;
    const auto& other =
        source == HeadingSource::kGyro ? motion.odometry_turn_rad : motion.gyro_turn_rad;
    return wanted ? *wanted : other.value_or(0.0);
}

// SIGN of the paper; a difference that is only rounding is none.
double sign(double rad) {
    constexpr double kRounding_rad = 1e-9;
    return rad > kRounding_rad ? 1.0 : rad < -kRounding_rad ? -1.0 : 0.0;
}

DominantDirection directionFrom(double heading_rad, const HedrConfig& config) {
    return DominantDirection({.interval_rad = config.interval_rad,
                              .start_heading_rad = heading_rad,
                              .settled_m = config.direction_settled_m,
                              .known_rad = config.direction_rad});
}

}  // namespace

HedrConfig hedrPreset(HeadingSource source) {
    HedrConfig config;
    config.heading_source = source;
    if (source == HeadingSource::kEncoders) {
        config.interval_rad = radFromDeg(90.0);
        config.compliant_rad = kPi;
        config.gain_rad_s2 = radFromDeg(0.05);
        config.damping_rad_s = radFromDeg(0.6);
        config.direction_settled_m = 8.0;
    }
    return config;
}

Hedr::Hedr(const Pose<World>& start, const HedrConfig& config)
    : config_(config), pose_(start), direction_(directionFrom(start.heading_rad, config)) {}

void Hedr::setDirection(std::optional<double> direction_rad) {
    config_.direction_rad = direction_rad;
    direction_ = directionFrom(pose_.heading_rad, config_);
    off_rad_ = 0.0;
}

void Hedr::update(const Motion& motion) {
    const double turn_rad = yawTurn(motion, config_.heading_source);
    standing_bias_rad_s_ = motion.gyro_bias_rad_s;
    judge(motion, turn_rad);
    if (status_.reason == SuspendReason::kSearching || status_.reason == SuspendReason::kNone) {
        direction_.observe(pose_.heading_rad + turn_rad, motion.distance_m);
    }
    const bool active = status_.state == HedrState::kActive;
    if (active && motion.dt_s <= kLongestLesson_s) learn(motion.dt_s);
    if (active || status_.reason == SuspendReason::kOffCorridors) watchLock(motion.distance_m);
    age(motion.dt_s);
    // Differs from the paper: what a gyro says while the wheels stand still is drift.
    const double corrected_s = std::min(motion.dt_s, std::max(config_.hold_s, kLongestLesson_s));
    const double corrected_turn_rad =
        motion.standing ? 0.0 : turn_rad + correction_rad_s_ * corrected_s;  // Eq. (9)
    pose_ = advanced(pose_, motion.distance_m, corrected_turn_rad);
}

// Differs from the paper: section 2.1 promises suspension, Eq. (10) leaves it out.
void Hedr::judge(const Motion& motion, double turn_rad) {
    rate_rad_s_ += (turn_rad - rate_rad_s_ * motion.dt_s) / (kRateFilter_s + motion.dt_s);
    status_.reason = SuspendReason::kNone;
    if (motion.standing) {
        status_.reason = SuspendReason::kStanding;
    } else if (std::abs(rate_rad_s_) > config_.turn_rate_rad_s) {
        status_.reason = SuspendReason::kTurning;
    } else if (!direction_.trustedAt(pose_.heading_rad)) {
        status_.reason = SuspendReason::kSearching;
    } else if (std::abs(direction_.deviation_rad(pose_.heading_rad)) > config_.compliant_rad) {
        status_.reason = SuspendReason::kOffCorridors;
    }
    const bool active = status_.reason == SuspendReason::kNone;
    status_.state = active ? HedrState::kActive : HedrState::kSuspended;
    status_.seconds_since_active = active ? 0.0 : status_.seconds_since_active + motion.dt_s;
}

// Eq. (7b). Differs from the paper: the printed sign is positive feedback. A heading left of a
// direction (deviation > 0) means that the drift is positive, so I must fall. A relay around two
// integrators swings without end, so a small part acts on the heading itself.
void Hedr::learn(double dt_s) {
    const double left = sign(direction_.deviation_rad(pose_.heading_rad));
    correction_rad_s_ -= left * config_.gain_rad_s2 * dt_s;
    pose_.heading_rad -= left * config_.damping_rad_s * dt_s;
    const double share = dt_s / (config_.drift_window_s + dt_s);
    status_.drift_rad_s += share * (-correction_rad_s_ - status_.drift_rad_s);
}

// Differs from the paper, which does not say when it is lost. A heading that has nothing to do with
// the directions is a quarter of the interval off on the average.
void Hedr::watchLock(double distance_m) {
    const double path_m = std::abs(distance_m);
    const double off_rad = std::abs(direction_.deviation_rad(pose_.heading_rad));
    off_rad_ += path_m / (kLockMemory_m + path_m) * (off_rad - off_rad_);
    status_.lost = off_rad_ > kLostShare * config_.interval_rad;
}

// Differs from the paper: what I has gathered lately fades, and what it has held on the average
// for a minute, the drift, is dropped too when nothing has confirmed it for long.
void Hedr::age(double dt_s) {
    status_.held_expired = status_.seconds_since_active > config_.hold_s;
    if (status_.held_expired) status_.drift_rad_s = 0.0;
    const double keep = config_.leak_s / (config_.leak_s + dt_s);
    correction_rad_s_ = keep * (correction_rad_s_ + status_.drift_rad_s) - status_.drift_rad_s;
}

}  // namespace hedr
