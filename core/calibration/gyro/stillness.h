#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/calibration/gyro/gyro_stretch.h"
#include "core/calibration/gyro/motion_sign.h"
#include "core/calibration/gyro_samples.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"

namespace hedr {

// From … to, robot time.
struct StandingTime {
    double begin_s = 0.0;
    double end_s = 0.0;

    double duration_s() const { return end_s - begin_s; }
    friend bool operator==(const StandingTime&, const StandingTime&) = default;
};

// A time during which the robot moved, and by what it was first noticed.
struct Disturbance {
    MotionSign sign{};
    double until_s = 0.0;
    // Calm, but the rate is not what it was before: it still turns, or it turned before, or the
    // bias jumped.
    bool rate_changed = false;
};

// How near to motion it was when it was looked at.
struct Unrest {
    double t_s = 0.0;
    double strength = 0.0;  // of the strongest hint by the gyro; above 1: it moves
};

// Whether a robot stands, told live from its gyro and its encoders, if there are any. Noise and
// bias of the gyro are learned while it stands. A turn that is as slow as a bias and lasts from the
// beginning looks like a bias: only encoders tell it. One that begins later is told by the change.
class Stillness {
  public:
    enum class State : unsigned char { kTooEarly, kStands, kMoves };

    explicit Stillness(const Vehicle& vehicle) : vehicle_(vehicle) {}

    // In the order of time.
    void add(const GyroSample& sample);
    void add(double t_s, const Odometry& odometry);

    State state() const { return state_; }
    bool hasWheels() const { return wheels_.has_value(); }
    // kMoves: the last of them is the reason.
    const std::vector<Disturbance>& disturbances() const { return disturbances_; }
    // Times of standing; while it stands, the last one goes on.
    const std::vector<StandingTime>& standing() const { return standing_; }
    const std::vector<Unrest>& unrest() const { return unrest_; }  // twice a second

  private:
    // How it was before it moved.
    struct Level {
        double rate_rad_s = 0.0;
        double span_s = 0.0;
        double noise_rad_s_sqrthz = 0.0;
        double variance = 0.0;
    };
    void look();
    void noteSign(const MotionSign& sign);
    void noteMotion(const MotionSign& sign);
    void startAfter(double t_s);
    void endStanding(const MotionSign& sign);
    std::optional<Level> levelBefore(const MotionSign& sign) const;
    void begin();
    bool hasSettled();
    bool rateIsAsBefore() const;

    Vehicle vehicle_;
    State state_ = State::kTooEarly;
    std::vector<Disturbance> disturbances_{};
    std::vector<StandingTime> standing_{};
    std::vector<Unrest> unrest_{};
    LoneReadingFilter filter_{};
    GyroStretch stretch_{};
    std::optional<Odometry> wheels_{};  // when it was last seen to stand
    static constexpr double kNever_s = -std::numeric_limits<double>::infinity();
    double calm_from_s_ = kNever_s;
    double next_look_s_ = kNever_s;
    double looked_s_ = kNever_s;    // up to there
    double looked_at_all_s_ = 0.0;  // when the stretch was so long
    bool waits_ = false;            // to see how a sign goes on
    std::optional<Level> reference_{};
};

// The readings of a recording, or of all that came until now.
Stillness stillnessIn(std::span<const SensorReport> reports, const GyroSamples& gyro,
                      const Vehicle& vehicle);

}  // namespace hedr
