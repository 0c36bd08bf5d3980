#pragma once

#include <cmath>
#include <optional>

#include "core/fusion/compass.h"
#include "core/fusion/pose_covariance.h"
#include "core/fusion/sensor_noise.h"
#include "core/robot/motion.h"

namespace hedr {

// Which heading corrects the wheels'.
enum class GhHeading : unsigned char { kGyro, kMagnetometer, kCombined };

// The shares alpha and beta are those of a sample of 10 ms, the paper's; a longer sample takes
// more, so that they mean the same at every sampling rate. Defaults: the authors' public firmware.
struct GhConfig {
    double alpha = 0.2;  // of the sensed heading
    double beta = 0.3;   // of the newest turn rate of the wheels
    double gamma = 0.9;  // of the gyro against the magnetometer
    MagnetometerRange magnetometer{};
    WheelNoise wheels{};
    GyroNoise gyro{};
    MagneticNoise magnetic{};
};

// A share per 10 ms, as it is over another time.
class ShareOverTime {
  public:
    explicit ShareOverTime(double per_10_ms) : rest_per_10_ms_(1.0 - per_10_ms) {}

    double over(double dt_s) {
        if (dt_s != dt_s_) {
            dt_s_ = dt_s;
            share_ = 1.0 - std::pow(rest_per_10_ms_, dt_s / kReference_s);
        }
        return share_;
    }

  private:
    static constexpr double kReference_s = 0.01;
    double rest_per_10_ms_;
    double dt_s_ = 0.0;
    double share_ = 0.0;
};

// Zimoch, Giobazolias, Girousis, Mozhaev, "Investigating effects of sensor fusion of multiple
// combinations of sensors on robotic localisation uncertainty", University of Bristol, 2019: the
// wheels' turn rate, smoothed, predicts the heading, and a gyro, a magnetometer or a blend of both
// corrects it.
class GhFilter {
  public:
    GhFilter(const Pose<World>& start, GhHeading heading, const GhConfig& config);

    void update(const Motion& motion);
    const Pose<World>& pose() const { return pose_; }
    double gyro_bias_rad_s() const { return bias_rad_s_; }
    Eigen::Matrix3d covariance() const;

  private:
    std::optional<double> sensedHeading(const Motion& motion, double turn_rad);
    void spread(const Motion& motion, Vector<World> way, double turn_rad);

    GhHeading heading_;
    GhConfig config_;
    ShareOverTime alpha_;
    ShareOverTime beta_;
    Compass compass_;
    Pose<World> pose_;
    double gyro_heading_rad_;
    double rate_rad_s_ = 0.0;
    double unsensed_s_ = 0.0;  // since the last correction
    double bias_rad_s_ = 0.0;

    // The heading's error is a blend of its sensors', and so is the position's.
    PoseCovariance by_wheels_{};
    PoseCovariance by_gyro_;
    PoseCovariance by_field_{};
};

}  // namespace hedr
