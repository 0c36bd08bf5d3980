#include "core/simulation/sensor_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simulation/wheels.h"

namespace hedr {

namespace {

constexpr double kSlipTime_s = 1.0;
constexpr double kTurnSlipTime_s = 5.0;

struct TrueStep {
    double forward_m = 0.0;
    double turn_rad = 0.0;
};

TrueStep motionBetween(const Pose<World>& before, const Pose<World>& after) {
    const double middle = 0.5 * (before.heading_rad + after.heading_rad);
    const Vector<World> d = after.position - before.position;
    return {d.x * std::cos(middle) + d.y * std::sin(middle),
            after.heading_rad - before.heading_rad};
}

// Two tracks that slip along their way and, in turns, across it.
class Tracks {
  public:
    Tracks(const VehicleGeometry& geometry, const SensorErrors& errors, double step_s)
        : geometry_(geometry),
          errors_(errors),
          left_slip_(kSlipTime_s, step_s),
          right_slip_(kSlipTime_s, step_s),
          turn_slip_(kTurnSlipTime_s, step_s) {}

    void move(const TrueStep& motion, Random& random) {
        const double widening =
            std::clamp(errors_.turn_slip_spread * turn_slip_.next(random), -0.5, 0.5);
        const double half_turn_m = 0.5 * motion.turn_rad * geometry_.wheelbase_m * (1.0 + widening);
        left_m_ +=
            (motion.forward_m - half_turn_m) * (1.0 + errors_.track_slip * left_slip_.next(random));
        right_m_ += (motion.forward_m + half_turn_m) *
                    (1.0 + errors_.track_slip * right_slip_.next(random));
    }

    WheelTicks ticks() const { return wheelCounts(geometry_, left_m_, right_m_); }

  private:
    VehicleGeometry geometry_;
    SensorErrors errors_;
    CorrelatedNoise left_slip_;
    CorrelatedNoise right_slip_;
    CorrelatedNoise turn_slip_;
    double left_m_ = 0.0;
    double right_m_ = 0.0;
};

class GyroSensor {
  public:
    GyroSensor(const SensorErrors& errors, double step_s, Random& random)
        : errors_(errors),
          step_s_(step_s),
          bias_rad_s_(random.uniform(-errors.gyro_bias_rad_s, errors.gyro_bias_rad_s)) {}

    GyroRate measure(const TrueStep& motion, Random& random) {
        bias_rad_s_ += errors_.gyro_bias_walk_rad_s_sqrts * std::sqrt(step_s_) * random.normal();
        const double noise = errors_.gyro_noise_rad_s_sqrthz / std::sqrt(step_s_) * random.normal();
        const double rate = motion.turn_rad / step_s_;
        return {(1.0 + errors_.gyro_scale_error) * rate + bias_rad_s_ + noise};
    }

  private:
    SensorErrors errors_;
    double step_s_;
    double bias_rad_s_;
};

}  // namespace

std::vector<SensorReport> sensorReports(std::span<const Pose<World>> truth, double rate_hz,
                                        const VehicleGeometry& geometry, const SensorErrors& errors,
                                        Random& random) {
    Tracks tracks(geometry, errors, 1.0 / rate_hz);
    GyroSensor gyro(errors, 1.0 / rate_hz, random);
    std::vector<SensorReport> reports;
    reports.reserve(truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const TrueStep motion = i == 0 ? TrueStep{} : motionBetween(truth[i - 1], truth[i]);
        tracks.move(motion, random);
        reports.push_back({.robot_time_s = static_cast<double>(i) / rate_hz,
                           .odometry = tracks.ticks(),
                           .gyro = gyro.measure(motion, random)});
    }
    return reports;
}

}  // namespace hedr
