#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/calibration/compass/magnetometer.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr::test {

// A robot that turns on the spot and reports its magnetic field. Sizes of field errors are shares
// of the ellipse's radius.
struct MagneticBench {
    MagnetometerRange truth{0.12, -0.31, 0.25, 0.21, 0.2};
    double vertical = 0.4;
    std::vector<double> turns{2, -2};  // counter-clockwise positive, a stand after each
    double speed_deg_s = 60.0;
    double unevenness = 0.0;  // of the speed, 0 … 1
    double rate_hz = 25.0;
    double stand_s = 2.0;
    // The sensor.
    double noise = 0.01;
    double correlated = 0.0;  // noise that forgets itself
    double correlation_s = 0.5;
    double step = 0.0;             // of the readings
    double clip = 1e9;             // the sensor's range, in radii of the ellipse about its middle
    double burst = 0.0;            // size of one
    std::size_t burst_from = 300;  // reading
    std::size_t burst_length = 20;
    // The surroundings.
    double gradient = 0.0;     // a field that goes twice round a turn
    double third_wave = 0.0;   // of the length, three times a turn
    double other_turns = 0.0;  // the field is moved by so much in every second stretch
    double tilt = 0.0;         // unsteadiness of the vertical field, correlated, and in part in x
    double drift_deg_s = 0.0;  // of the field's direction
    double fade_per_s = 0.0;   // of the field's strength
    // The judge.
    bool has_gyro = true;
    bool has_wheels = false;
    double gyro_scale = 1.0;
    double gyro_bias_deg_s = 0.3;
    double gyro_noise_deg_s = 0.1;
};

class MagneticRecord {
  public:
    MagneticRecord(const MagneticBench& bench, std::uint64_t seed)
        : bench_(bench),
          random_(seed),
          hand_(0.7, 1.0 / bench.rate_hz),
          slow_(bench.correlation_s, 1.0 / bench.rate_hz),
          slow_y_(bench.correlation_s, 1.0 / bench.rate_hz),
          tilting_(1.0, 1.0 / bench.rate_hz),
          heading_rad_(random_.uniform(-kPi, kPi)),
          phase_rad_(random_.uniform(-kPi, kPi)) {
        stand(bench.stand_s);
        for (const double turns : bench.turns) {
            ++stretch_;
            turn(360.0 * turns);
            stand(bench.stand_s);
        }
    }

    void stand(double time_s) {
        for (double until_s = time_s_ + time_s; time_s_ < until_s;) add(0.0);
    }
    void turn(double angle_deg) {
        const double end_rad = heading_rad_ + radFromDeg(angle_deg);
        const double way = angle_deg > 0.0 ? 1.0 : -1.0;
        while (way * (end_rad - heading_rad_) > 0.0) {
            const double pace =
                1.0 + bench_.unevenness * std::clamp(hand_.next(random_), -0.9, 3.0);
            add(way * radFromDeg(bench_.speed_deg_s) * pace);
        }
    }
    // Straight on, where the field may be another one.
    void drive(double way_m) {
        for (double gone_m = 0.0; gone_m < way_m; gone_m += 0.01) {
            travel_m_ += 0.01;
            add(0.0);
        }
    }

    SampleSet set{};

  private:
    double rad() const {
        return std::sqrt(std::abs(bench_.truth.range_x * bench_.truth.range_y) *
                         std::sqrt(1.0 - bench_.truth.correlation * bench_.truth.correlation));
    }

    void add(double rate_rad_s) {
        const double dt_s = 1.0 / bench_.rate_hz;
        time_s_ += dt_s;
        heading_rad_ += rate_rad_s * dt_s;
        SensorReport report{.robot_time_s = time_s_};
        report.magnetic_field = field();
        if (bench_.has_gyro) {
            const double noise_deg_s =
                bench_.gyro_bias_deg_s + bench_.gyro_noise_deg_s * random_.normal();
            report.gyro = GyroRate{rate_rad_s / bench_.gyro_scale + radFromDeg(noise_deg_s)};
        }
        if (bench_.has_wheels) {
            report.odometry =
                WheelTravel{travel_m_ - 0.2 * heading_rad_, travel_m_ + 0.2 * heading_rad_};
        }
        set.reports.push_back(report);
    }

    MagneticField field() {
        const double angle_rad = -(heading_rad_ - radFromDeg(bench_.drift_deg_s) * time_s_);
        const double length = (1.0 + bench_.third_wave * std::cos(3.0 * angle_rad + phase_rad_)) *
                              (1.0 + bench_.fade_per_s * time_s_);
        double ahead =
            length * std::cos(angle_rad) + bench_.gradient * std::cos(2.0 * angle_rad + phase_rad_);
        double left =
            length * std::sin(angle_rad) + bench_.gradient * std::sin(2.0 * angle_rad + phase_rad_);
        if (stretch_ % 2 == 0) ahead += bench_.other_turns;
        const double tilt = bench_.tilt * tilting_.next(random_);
        ahead += 0.5 * tilt;
        const MagnetometerRange& truth = bench_.truth;
        const double c = truth.correlation;
        left = std::sqrt(1.0 - c * c) * left + c * ahead;
        const double noise_x =
            bench_.noise * random_.normal() + bench_.correlated * slow_.next(random_);
        const double noise_y =
            bench_.noise * random_.normal() + bench_.correlated * slow_y_.next(random_);
        ++readings_;
        const bool bursts =
            readings_ > bench_.burst_from && readings_ <= bench_.burst_from + bench_.burst_length;
        const double burst = bursts ? bench_.burst : 0.0;
        const double z_noise = bench_.noise * random_.normal() + tilt;
        return {asRead(truth.centre_x + truth.range_x * ahead + rad() * (noise_x + burst)),
                asRead(truth.centre_y + truth.range_y * left + rad() * (noise_y + burst)),
                asRead(bench_.vertical + rad() * z_noise)};
    }
    double asRead(double value) const {
        const double limit = std::abs(bench_.truth.centre_x) + bench_.clip * rad();
        value = std::clamp(value, -limit, limit);
        const double step = bench_.step * rad();
        return step > 0.0 ? step * std::round(value / step) : value;
    }

    MagneticBench bench_;
    Random random_;
    CorrelatedNoise hand_;
    CorrelatedNoise slow_;
    CorrelatedNoise slow_y_;
    CorrelatedNoise tilting_;
    double heading_rad_;
    double phase_rad_;
    double time_s_ = 0.0;
    double travel_m_ = 0.0;
    int stretch_ = 0;
    std::size_t readings_ = 0;
};

inline MagnetometerCalibration calibrationOf(const MagneticBench& bench, std::uint64_t seed,
                                             const Vehicle& vehicle = {}) {
    const std::vector sets{MagneticRecord(bench, seed).set};
    return calibrateMagnetometer(sets, vehicle);
}

}  // namespace hedr::test
