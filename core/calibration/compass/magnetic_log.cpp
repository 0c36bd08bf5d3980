#include "core/calibration/compass/magnetic_log.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/gyro/gyro_stands.h"
#include "core/calibration/gyro_samples.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kTurnedAtAll_rad = 0.5;
constexpr double kLongestHeadingStep_s = 0.5;  // over a longer one a rate tells no heading
constexpr double kSureStep_rad = 0.02;         // smaller ones do not tell the way it turns

// Something cumulative at the times it was reported.
struct TimedSum {
    std::vector<double> t_s{};
    std::vector<double> value{};

    void add(double time_s, double step) {
        t_s.push_back(time_s);
        value.push_back(value.empty() ? step : value.back() + step);
    }
    double at(double time_s) const {
        if (t_s.empty()) return 0.0;
        const auto later = std::lower_bound(t_s.begin(), t_s.end(), time_s) - t_s.begin();
        const auto next = static_cast<std::size_t>(later);
        if (next == 0) return value.front();
        if (next == t_s.size()) return value.back();
        const double way = (time_s - t_s[next - 1]) / (t_s[next] - t_s[next - 1]);
        return value[next - 1] + way * (value[next] - value[next - 1]);
    }
    bool hasTurned() const {
        const auto [least, most] = std::minmax_element(value.begin(), value.end());
        return !value.empty() && *most - *least > kTurnedAtAll_rad;
    }
};

TimedSum gyroHeading(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    TimedSum heading;
    const auto gyro = gyroSamplesOf(reports);
    if (!gyro) return heading;
    const double bias_rad_s = vehicle.gyro_bias_rad_s.value_or(0.0);
    for (const GyroSample& sample : withoutLoneReadings(gyro->samples)) {
        const double dt_s = std::min(sample.dt_s, kLongestHeadingStep_s);
        heading.add(sample.t_s, (vehicle.gyro_scale * sample.rate_rad_s - bias_rad_s) * dt_s);
    }
    return heading;
}

struct WheelSums {
    TimedSum heading_rad{};
    TimedSum travel_m{};
};

WheelSums wheelSums(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    WheelSums sums;
    Odometry last;
    for (const SensorReport& report : reports) {
        if (std::holds_alternative<std::monostate>(report.odometry)) continue;
        const bool goes_on =
            std::isfinite(report.robot_time_s) &&
            (sums.travel_m.t_s.empty() || report.robot_time_s > sums.travel_m.t_s.back());
        if (!goes_on) continue;
        const WheelMotion moved = wheelMotionBetween(last, report.odometry, vehicle);
        last = report.odometry;
        const double turn_rad = moved.turn_rad.value_or(0.0);
        if (!std::isfinite(turn_rad) || !std::isfinite(moved.distance_m)) continue;
        sums.heading_rad.add(report.robot_time_s, turn_rad);
        sums.travel_m.add(report.robot_time_s, moved.distance_m);
    }
    return sums;
}

bool turnOppositeWays(const TimedSum& gyro, const TimedSum& wheels) {
    double together = 0.0;
    constexpr double kStep_s = 1.0;
    const double end_s = std::min(gyro.t_s.back(), wheels.t_s.back());
    for (double t_s = gyro.t_s.front(); t_s + kStep_s <= end_s; t_s += kStep_s) {
        const double by_gyro_rad = gyro.at(t_s + kStep_s) - gyro.at(t_s);
        const double by_wheels_rad = wheels.at(t_s + kStep_s) - wheels.at(t_s);
        if (std::abs(by_gyro_rad) < kSureStep_rad) continue;
        together += by_gyro_rad * by_wheels_rad;
    }
    return together < 0.0;
}

void addFields(MagneticLog& log, std::span<const SensorReport> reports) {
    for (const SensorReport& report : reports) {
        if (!report.magnetic_field) continue;
        const Eigen::Vector3d field(report.magnetic_field->x, report.magnetic_field->y,
                                    report.magnetic_field->z);
        const bool goes_on = std::isfinite(report.robot_time_s) &&
                             (log.samples.empty() || report.robot_time_s > log.samples.back().t_s);
        if (field.allFinite() && goes_on) {
            log.samples.push_back({report.robot_time_s, field});
        } else {
            ++log.broken;
        }
    }
}

}  // namespace

MagneticLog readMagneticLog(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    MagneticLog log;
    addFields(log, reports);
    const TimedSum gyro = gyroHeading(reports, vehicle);
    const WheelSums wheels = wheelSums(reports, vehicle);
    const bool gyro_turned = gyro.hasTurned();
    const bool wheels_turned = wheels.heading_rad.hasTurned();
    log.judges_disagree =
        gyro_turned && wheels_turned && turnOppositeWays(gyro, wheels.heading_rad);
    const bool by_wheels =
        wheels_turned && (!gyro_turned || vehicle.heading_source == HeadingSource::kEncoders);
    if (gyro_turned || wheels_turned) {
        log.judge = by_wheels ? HeadingJudge::kEncoders : HeadingJudge::kGyro;
    }
    for (MagneticSample& sample : log.samples) {
        sample.turned_rad = by_wheels ? wheels.heading_rad.at(sample.t_s) : gyro.at(sample.t_s);
        sample.travelled_m = wheels.travel_m.at(sample.t_s);
    }
    return log;
}

}  // namespace hedr
