#include "core/robot/motion.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace hedr {

namespace {

constexpr double kStandingAfter_s = 0.5;
constexpr double kStillSpeed_m_s = 1e-3;
constexpr double kStillTurn_rad_s = radFromDeg(0.05);
constexpr double kPushedTurn_rad_s = radFromDeg(5.0);  // faster than any drift: somebody turns it
constexpr double kRateFilter_s = 0.3;
constexpr double kShortestBiasMeasurement_s = 1.0;
constexpr double kLongestGyroStep_s = 2.0;
constexpr double kFastestTurn_rad_s = radFromDeg(1000.0);
constexpr int kRestartAfterImplausible = 3;

// The counters' difference, the short way round a counter of `bits`.
double countsBetween(std::int64_t before, std::int64_t now, int bits) {
    return std::remainder(static_cast<double>(now - before), std::ldexp(1.0, bits));
}

}  // namespace

MotionBuilder::MotionBuilder(const Vehicle& vehicle, double clock_period_s)
    : vehicle_(vehicle),
      clock_period_s_(clock_period_s),
      bias_rad_s_(vehicle.gyro_bias_rad_s.value_or(0.0)) {}

void MotionBuilder::restart() {
    if (started_) ++restarts_;
    started_ = false;
}

std::optional<Motion> MotionBuilder::add(const SensorReport& report) {
    if (!std::isfinite(report.robot_time_s)) return std::nullopt;
    if (started_ && elapsed(report.robot_time_s) < 0.0) restart();
    if (!started_) {
        begin(report);
        return std::nullopt;
    }
    const double dt = elapsed(report.robot_time_s);
    if (dt == 0.0) return std::nullopt;  // what it counted shows in the next one

    const Wheels wheels = wheelsSince(last_odometry_, report.odometry);
    if (!plausible(wheels, t_s_ + dt - last_wheels_t_s_)) {
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
    motion.gyro_turn_rad = gyroTurn(report, dt, wheels);
    motion.standing = standingAfter(wheels, motion.gyro_turn_rad, dt);
    if (motion.gyro_turn_rad) *motion.gyro_turn_rad -= bias_rad_s_ * dt;
    motion.gyro_bias_rad_s = bias_rad_s_;

    t_s_ = motion.t_s;
    last_robot_time_s_ = report.robot_time_s;
    if (!std::holds_alternative<std::monostate>(report.odometry)) {
        last_odometry_ = report.odometry;
        last_wheels_t_s_ = t_s_;
    }
    if (!std::holds_alternative<std::monostate>(report.gyro)) last_gyro_ = report.gyro;
    return motion;
}

double MotionBuilder::elapsed(double robot_time_s) const {
    const double difference = robot_time_s - last_robot_time_s_;
    return std::isinf(clock_period_s_) ? difference : std::remainder(difference, clock_period_s_);
}

void MotionBuilder::begin(const SensorReport& report) {
    const bool first_ever = restarts_ == 0;
    // The first time is read as signed, so that a log that starts before zero keeps its times.
    if (first_ever) {
        t_s_ = std::isinf(clock_period_s_) ? report.robot_time_s
                                           : std::remainder(report.robot_time_s, clock_period_s_);
    }
    last_robot_time_s_ = report.robot_time_s;
    last_wheels_t_s_ = t_s_;
    last_odometry_ = report.odometry;
    last_gyro_ = report.gyro;
    implausible_in_a_row_ = 0;
    started_ = true;
}

MotionBuilder::Wheels MotionBuilder::wheelsSince(const Odometry& before,
                                                 const Odometry& now) const {
    if (before.index() != now.index()) return {};
    const VehicleGeometry& geometry = vehicle_.geometry;
    const auto differential = [&](double left_m, double right_m) {
        return Wheels{0.5 * (left_m + right_m), (right_m - left_m) / geometry.wheelbase_m};
    };
    if (const auto* ticks = std::get_if<WheelTicks>(&now)) {
        const auto& old = std::get<WheelTicks>(before);
        const double revolution = kPi / geometry.ticks_per_revolution;
        return differential(
            revolution * geometry.left_wheel_diameter_m *
                countsBetween(old.left, ticks->left, vehicle_.encoder_counter_bits),
            revolution * geometry.right_wheel_diameter_m *
                countsBetween(old.right, ticks->right, vehicle_.encoder_counter_bits));
    }
    if (const auto* travel = std::get_if<WheelTravel>(&now)) {
        const auto& old = std::get<WheelTravel>(before);
        return differential(travel->left_m - old.left_m, travel->right_m - old.right_m);
    }
    if (const auto* path = std::get_if<PathTravel>(&now)) {
        return {path->distance_m - std::get<PathTravel>(before).distance_m, std::nullopt};
    }
    if (const auto* pose = std::get_if<OdometryPose>(&now)) {
        const auto& old = std::get<OdometryPose>(before);
        const double turn = wrapAngle(pose->heading_rad - old.heading_rad);
        const double middle = old.heading_rad + 0.5 * turn;
        const double chord =
            std::cos(middle) * (pose->x_m - old.x_m) + std::sin(middle) * (pose->y_m - old.y_m);
        return {chord, turn};
    }
    return {};
}

bool MotionBuilder::plausible(const Wheels& wheels, double dt_s) const {
    return std::isfinite(wheels.distance_m) &&
           std::abs(wheels.distance_m) <= vehicle_.max_speed_m_s * std::max(dt_s, 0.1) &&
           std::abs(wheels.turn_rad.value_or(0.0)) <= kFastestTurn_rad_s * std::max(dt_s, 0.1);
}

std::optional<double> MotionBuilder::gyroTurn(const SensorReport& report, double dt_s,
                                              const Wheels& wheels) {
    if (const auto* angle = std::get_if<GyroAngle>(&report.gyro)) {
        if (const auto* old = std::get_if<GyroAngle>(&last_gyro_)) {
            const auto urad = static_cast<std::int32_t>(angle->urad - old->urad);
            return 1e-6 * vehicle_.gyro_scale * static_cast<double>(urad);
        }
        return 0.0;
    }
    if (const auto* rate = std::get_if<GyroRate>(&report.gyro)) {
        // Nobody watched the rate over a long gap; the wheels did.
        if (dt_s > kLongestGyroStep_s) return wheels.turn_rad.value_or(0.0) + bias_rad_s_ * dt_s;
        return vehicle_.gyro_scale * rate->rad_s * dt_s;
    }
    return std::nullopt;
}

bool MotionBuilder::standingAfter(const Wheels& wheels, const std::optional<double>& gyro_turn,
                                  double dt_s) {
    const double gyro_rate = gyro_turn ? *gyro_turn / dt_s - bias_rad_s_ : 0.0;
    gyro_rate_rad_s_ += (gyro_rate - gyro_rate_rad_s_) * dt_s / (kRateFilter_s + dt_s);
    const bool still = std::abs(wheels.distance_m) < kStillSpeed_m_s * dt_s &&
                       std::abs(wheels.turn_rad.value_or(0.0)) < kStillTurn_rad_s * dt_s &&
                       std::abs(gyro_rate_rad_s_) < kPushedTurn_rad_s;
    still_s_ = still ? still_s_ + dt_s : 0.0;
    if (!still) moved_ = true;
    if (!moved_ && gyro_turn && !vehicle_.gyro_bias_rad_s) {
        standing_turn_rad_ += *gyro_turn;
        standing_time_s_ += dt_s;
        if (standing_time_s_ >= kShortestBiasMeasurement_s) {
            bias_rad_s_ = standing_turn_rad_ / standing_time_s_;
        }
    }
    return still_s_ >= kStandingAfter_s;
}

}  // namespace hedr
