#include "core/robot/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kStandingAfter_s = 0.5;
constexpr double kStillSpeed_m_s = 1e-3;
constexpr double kStillTurn_rad_s = radFromDeg(0.05);
constexpr double kPushedTurn_rad_s = radFromDeg(5.0);  // faster than any drift: somebody turns it
constexpr double kRateFilter_s = 0.3;
constexpr double kShortestBiasMeasurement_s = 1.0;
constexpr double kMomentBeforeMoving_s = 0.25;
constexpr double kLongestGyroStep_s = 2.0;
constexpr double kJitter_s = 0.1;       // time stamps closer than this say little about a speed
constexpr double kLongestGap_s = 10.0;  // travel unseen for longer cannot be told from a restart
constexpr double kFastestTurn_rad_s = radFromDeg(1000.0);
constexpr double kLongestStep_s = 86400.0;
constexpr double kShortestStep_s = 0.5e-6;  // robots count microseconds
constexpr double kLatestTime_s = 1e11;      // later, steps are lost in rounding
constexpr int kRestartAfterImplausible = 3;

bool finite(const WheelTravel& travel) {
    return std::isfinite(travel.left_m) && std::isfinite(travel.right_m);
}
bool finite(const PathTravel& travel) { return std::isfinite(travel.distance_m); }
bool finite(const OdometryPose& pose) {
    return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.heading_rad);
}
bool finite(const GyroRate& rate) { return std::isfinite(rate.rad_s); }
template <class Whole>  // counts, microradians, nothing
bool finite(const Whole&) {
    return true;
}

bool usable(const SensorReport& report) {
    const auto is_finite = [](const auto& known) { return finite(known); };
    return std::abs(report.robot_time_s) <= kLatestTime_s &&
           std::visit(is_finite, report.odometry) && std::visit(is_finite, report.gyro);
}

std::optional<MagneticField> finiteField(const std::optional<MagneticField>& field) {
    const bool good =
        field && std::isfinite(field->x) && std::isfinite(field->y) && std::isfinite(field->z);
    return good ? field : std::nullopt;
}

}  // namespace

MotionBuilder::MotionBuilder(const Vehicle& vehicle, double clock_period_s)
    : vehicle_(vehicle),
      clock_period_s_(clock_period_s),
      bias_rad_s_(vehicle.gyro_bias_rad_s.value_or(0.0)) {}

void MotionBuilder::restart() {
    if (started_) ++restarts_;
    started_ = false;
    same_boot_ = false;
}

std::optional<Motion> MotionBuilder::add(const SensorReport& report) {
    if (!usable(report)) {
        ++broken_samples_;
        return std::nullopt;
    }
    if (started_ && elapsed(report.robot_time_s) < 0.0) restart();
    if (!started_) {
        begin(report);
        return std::nullopt;
    }
    const double dt = elapsed(report.robot_time_s);
    if (dt < kShortestStep_s) return std::nullopt;  // what it counted shows in the next one

    const WheelMotion wheels = wheelMotionBetween(last_odometry_, report.odometry, vehicle_);
    const std::optional<double> gyro_turn = gyroTurn(report, dt);
    if (dt > kLongestStep_s ||
        !plausible(wheels, gyro_turn.value_or(0.0), t_s_ + dt - last_wheels_t_s_)) {
        ++broken_samples_;
        // One wild sample is noise; several agree that the counters were started afresh.
        if (++implausible_in_a_row_ >= kRestartAfterImplausible) restart();
        return std::nullopt;
    }
    implausible_in_a_row_ = 0;

    Motion motion;
    motion.dt_s = dt;
    motion.t_s = t_s_ + dt;
    motion.distance_m = wheels.distance_m;
    motion.odometry_turn_rad = wheels.turn_rad;
    motion.standing = standingAfter(report, wheels, gyro_turn, dt);
    motion.gyro_silent = !gyro_turn && gyroWasHeardBefore();
    if (gyro_turn) motion.gyro_turn_rad = *gyro_turn - bias_rad_s_ * dt;
    if (motion.gyro_silent) motion.gyro_turn_rad = wheels.turn_rad.value_or(0.0);
    motion.gyro_bias_rad_s = bias_rad_s_;
    if (standing_time_s_ >= kShortestBiasMeasurement_s) motion.bias_measured_s = standing_time_s_;
    motion.magnetic_field = finiteField(report.magnetic_field);

    t_s_ = motion.t_s;
    remember(report);
    return motion;
}

void MotionBuilder::remember(const SensorReport& report) {
    same_boot_ = false;
    last_robot_time_s_ = report.robot_time_s;
    if (!std::holds_alternative<std::monostate>(report.odometry)) {
        last_odometry_ = report.odometry;
        last_wheels_t_s_ = t_s_;
    }
    if (!std::holds_alternative<std::monostate>(report.gyro)) {
        last_gyro_ = report.gyro;
        last_gyro_t_s_ = t_s_;
    }
}

double MotionBuilder::elapsed(double robot_time_s) const {
    const double difference = robot_time_s - last_robot_time_s_;
    return std::isinf(clock_period_s_) ? difference : std::remainder(difference, clock_period_s_);
}

void MotionBuilder::begin(const SensorReport& report) {
    const bool first_ever = restarts_ == 0;
    // Counters that start afresh need not mean that the clock did.
    const double pause_s = first_ever ? 0.0 : elapsed(report.robot_time_s);
    if (pause_s > 0.0 && pause_s <= kLongestStep_s) t_s_ += pause_s;
    // The first time is read as signed, so that a log that starts before zero keeps its times.
    if (first_ever) {
        t_s_ = std::isinf(clock_period_s_) ? report.robot_time_s
                                           : std::remainder(report.robot_time_s, clock_period_s_);
    }
    last_robot_time_s_ = report.robot_time_s;
    last_wheels_t_s_ = t_s_;
    last_odometry_ = report.odometry;
    last_gyro_ = report.gyro;
    last_gyro_t_s_ = t_s_;
    implausible_in_a_row_ = 0;
    started_ = true;
}

bool MotionBuilder::plausible(const WheelMotion& wheels, double gyro_turn_rad, double dt_s) const {
    const double time_s = std::clamp(dt_s, kJitter_s, same_boot_ ? kLongestStep_s : kLongestGap_s);
    return std::isfinite(wheels.distance_m) &&
           std::abs(wheels.distance_m) <= vehicle_.max_speed_m_s * time_s &&
           std::abs(wheels.turn_rad.value_or(0.0)) <= kFastestTurn_rad_s * time_s &&
           std::abs(gyro_turn_rad) <= kFastestTurn_rad_s * time_s;
}

// None where nobody watched: a rate says nothing of what was before a long gap.
std::optional<double> MotionBuilder::gyroTurn(const SensorReport& report, double dt_s) const {
    if (const auto* angle = std::get_if<GyroAngle>(&report.gyro)) {
        if (const auto* old = std::get_if<GyroAngle>(&last_gyro_)) {
            const auto urad = static_cast<std::int32_t>(angle->urad - old->urad);
            return 1e-6 * vehicle_.gyro_scale * static_cast<double>(urad);
        }
        return 0.0;
    }
    if (const auto* rate = std::get_if<GyroRate>(&report.gyro)) {
        if (dt_s > kLongestGyroStep_s) return std::nullopt;
        return vehicle_.gyro_scale * rate->rad_s * dt_s;
    }
    // A row without a gyro value: an angle makes up for it later, a rate goes on for a while.
    if (std::holds_alternative<GyroAngle>(last_gyro_)) return 0.0;
    if (const auto* held = std::get_if<GyroRate>(&last_gyro_);
        held && t_s_ + dt_s - last_gyro_t_s_ <= kLongestGyroStep_s) {
        return vehicle_.gyro_scale * held->rad_s * dt_s;
    }
    return std::nullopt;
}

bool MotionBuilder::gyroWasHeardBefore() const {
    return !std::holds_alternative<std::monostate>(last_gyro_);
}

bool MotionBuilder::standingAfter(const SensorReport& report, const WheelMotion& wheels,
                                  const std::optional<double>& gyro_turn, double dt_s) {
    const bool by_hand = turnedByHand(gyro_turn, dt_s);
    // Wheels may report less often than the gyro: between their reports nobody knows.
    const bool no_wheels = std::holds_alternative<std::monostate>(last_odometry_);
    const bool counted = no_wheels || !std::holds_alternative<std::monostate>(report.odometry);
    const double since_wheels_s = no_wheels ? dt_s : t_s_ + dt_s - last_wheels_t_s_;
    const bool still =
        std::abs(wheels.distance_m) < kStillSpeed_m_s * since_wheels_s &&
        std::abs(wheels.turn_rad.value_or(0.0)) < kStillTurn_rad_s * since_wheels_s && !by_hand;
    if (!still) {
        moved_ = true;
        still_s_ = 0.0;
    } else if (counted) {
        still_s_ += since_wheels_s;
    }
    if (!moved_ && gyro_turn && !vehicle_.gyro_bias_rad_s) measureBias(*gyro_turn, dt_s);
    if (!moved_ && counted) commitBias();
    return still_s_ >= kStandingAfter_s && (counted || since_wheels_s < kJitter_s);
}

// Faster than any drift, or, as long as the drift is not known, than it did until now.
bool MotionBuilder::turnedByHand(const std::optional<double>& gyro_turn, double dt_s) {
    const double gyro_rate = gyro_turn ? *gyro_turn / dt_s - standingRate_rad_s() : 0.0;
    gyro_rate_rad_s_ += (gyro_rate - gyro_rate_rad_s_) * dt_s / (kRateFilter_s + dt_s);
    return std::abs(gyro_rate_rad_s_) >= kPushedTurn_rad_s;
}

double MotionBuilder::standingRate_rad_s() const {
    const double time_s = standing_time_s_ + held_time_s_ + latest_time_s_;
    const bool measuring = !moved_ && !vehicle_.gyro_bias_rad_s && time_s > 0.0;
    if (!measuring) return bias_rad_s_;
    const double rate_rad_s = (standing_turn_rad_ + held_turn_rad_ + latest_turn_rad_) / time_s;
    return std::clamp(rate_rad_s, -kLargestGyroBias_rad_s, kLargestGyroBias_rad_s);
}

void MotionBuilder::measureBias(double gyro_turn_rad, double dt_s) {
    latest_turn_rad_ += gyro_turn_rad;
    latest_time_s_ += dt_s;
}

// The last moment before it moves does not count: with coarse encoders a robot has turned a little
// before the first count comes.
void MotionBuilder::commitBias() {
    if (latest_time_s_ < kMomentBeforeMoving_s) return;
    standing_turn_rad_ += held_turn_rad_;
    standing_time_s_ += held_time_s_;
    held_turn_rad_ = std::exchange(latest_turn_rad_, 0.0);
    held_time_s_ = std::exchange(latest_time_s_, 0.0);
    if (standing_time_s_ >= kShortestBiasMeasurement_s)
        bias_rad_s_ = standing_turn_rad_ / standing_time_s_;
}

}  // namespace hedr
