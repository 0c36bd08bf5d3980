#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/geometry/angle.h"
#include "core/robot/report.h"
#include "core/robot/vehicle.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

inline constexpr double kLargestGyroBias_rad_s = radFromDeg(20.0);  // of cheap gyros' data sheets

// What happened between two sensor reports: the input of every estimator.
struct Motion {
    double t_s = 0.0;         // robot time, made continuous over wraps and restarts
    double dt_s = 0.0;        // > 0
    double distance_m = 0.0;  // signed travel of the robot's centre
    std::optional<double> odometry_turn_rad{};      // none where the wheels are not told apart
    std::optional<double> gyro_turn_rad{};          // scale and standing bias already removed
    bool gyro_silent = false;                       // not heard: that turn is the wheels'
    double gyro_bias_rad_s = 0.0;                   // what was removed
    double bias_measured_s = 0.0;                   // over so much standing at the start
    std::optional<MagneticField> magnetic_field{};  // as reported, but finite
    bool standing = false;                          // the wheels have been still for a while
};

// Turns reports into motions. Counters may wrap, time may wrap, jump or go back, samples may be
// missing or broken; after a restart of the robot counting starts afresh where the robot stands.
// A sample is broken, and counted, where a value is no finite number, where the robot would have
// moved faster than it can, or where a day would have passed. Several impossible ones in a row are
// a restart.
class MotionBuilder {
  public:
    static constexpr double kNoWrap = std::numeric_limits<double>::infinity();

    // `clock_period_s`: robot time wraps at it.
    explicit MotionBuilder(const Vehicle& vehicle, double clock_period_s = kNoWrap);

    // No motion for the first report, a repeated time stamp or a broken sample.
    std::optional<Motion> add(const SensorReport& report);

    // Counters and time start again at the next report, for a robot that says it was restarted.
    void restart();
    // The next report follows on the last one, however long ago that was: for a robot that says
    // that it was not restarted between them.
    void goOnAfterGap() { same_boot_ = started_; }

    bool started() const { return started_; }
    double time_s() const { return t_s_; }
    // A robot time near that of the last report, on the continuous scale of Motion::t_s.
    double continuous(double robot_time_s) const { return t_s_ + elapsed(robot_time_s); }
    std::uint64_t restarts() const { return restarts_; }
    std::uint64_t brokenSamples() const { return broken_samples_; }

  private:
    double elapsed(double robot_time_s) const;
    void begin(const SensorReport& report);
    bool plausible(const WheelMotion& wheels, double gyro_turn_rad, double dt_s) const;
    void remember(const SensorReport& report);
    std::optional<double> gyroTurn(const SensorReport& report, double dt_s) const;
    bool gyroWasHeardBefore() const;
    void measureBias(double gyro_turn_rad, double dt_s);
    void commitBias();
    double standingRate_rad_s() const;
    bool turnedByHand(const std::optional<double>& gyro_turn, double dt_s);
    bool standingAfter(const SensorReport& report, const WheelMotion& wheels,
                       const std::optional<double>& gyro_turn, double dt_s);

    Vehicle vehicle_;
    double clock_period_s_;
    bool started_ = false;
    bool same_boot_ = false;  // as in the last report, by the robot's word
    double t_s_ = 0.0;
    double last_robot_time_s_ = 0.0;
    double last_wheels_t_s_ = 0.0;
    Odometry last_odometry_{};
    Gyro last_gyro_{};
    double last_gyro_t_s_ = 0.0;

    double still_s_ = 0.0;
    double gyro_rate_rad_s_ = 0.0;  // low-passed, for the standing test
    bool moved_ = false;
    // Standing at the start, before anything moved, and its last two moments.
    double standing_turn_rad_ = 0.0;
    double standing_time_s_ = 0.0;
    double held_turn_rad_ = 0.0;
    double held_time_s_ = 0.0;
    double latest_turn_rad_ = 0.0;
    double latest_time_s_ = 0.0;
    double bias_rad_s_ = 0.0;

    int implausible_in_a_row_ = 0;
    std::uint64_t restarts_ = 0;
    std::uint64_t broken_samples_ = 0;
};

}  // namespace hedr
