#include "core/calibration/encoders/encoder_travel.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/gyro/gyro_stands.h"
#include "core/calibration/gyro_samples.h"
#include "core/robot/wheel_motion.h"

namespace hedr {

namespace {

constexpr double kCounted_m = 5e-4;  // fine encoders go to and fro by a count
constexpr double kStoodFor_s = 0.5;  // at the end of a test
constexpr double kBetweenTests_s = 2.0;
constexpr double kFastestWheel_m_s = 100.0;  // also if it counts ten times too much

struct WheelsTravel {
    double left_m = 0.0;
    double right_m = 0.0;
};

// None where the wheels are not told apart, or no number is.
std::optional<WheelsTravel> travelBetween(const Odometry& before, const Odometry& now,
                                          const Vehicle& vehicle) {
    const WheelMotion moved = wheelMotionBetween(before, now, vehicle);
    if (!moved.turn_rad || !std::isfinite(moved.distance_m + *moved.turn_rad)) return std::nullopt;
    const double half_m = 0.5 * vehicle.geometry.wheelbase_m * *moved.turn_rad;
    return WheelsTravel{moved.distance_m - half_m, moved.distance_m + half_m};
}

class EncoderReader {
  public:
    explicit EncoderReader(const Vehicle& vehicle) : vehicle_(vehicle) {}

    void add(const SensorReport& report) {
        if (std::holds_alternative<std::monostate>(report.odometry)) return;
        if (std::holds_alternative<PathTravel>(report.odometry)) travel.has_sides = false;
        if (!std::isfinite(report.robot_time_s) || !travelOf(report.odometry, report.odometry)) {
            travel.broken += travel.has_sides ? 1 : 0;
            return;
        }
        if (!travel.moments.empty()) {
            if (!follow(report)) return;
        } else {
            travel.moments.push_back({.t_s = report.robot_time_s});
            travel.moved_from_s = travel.moved_until_s = report.robot_time_s;
        }
        last_ = report.odometry;
    }

    EncoderTravel travel{};

  private:
    std::optional<WheelsTravel> travelOf(const Odometry& before, const Odometry& now) const {
        return travelBetween(before, now, vehicle_);
    }

    bool follow(const SensorReport& report) {
        EncoderMoment moment = travel.moments.back();
        const double dt_s = report.robot_time_s - moment.t_s;
        const auto moved = travelOf(last_, report.odometry);
        if (!moved || dt_s <= 0.0) return false;
        const double most_m = std::max(std::abs(moved->left_m), std::abs(moved->right_m));
        if (most_m > kFastestWheel_m_s * dt_s) {
            ++travel.broken;
            last_ = report.odometry;
            return false;
        }
        moment.t_s = report.robot_time_s;
        moment.left_m += moved->left_m;
        moment.right_m += moved->right_m;
        noteMotion(moment);
        travel.moments.push_back(moment);
        return true;
    }

    void noteMotion(const EncoderMoment& moment) {
        if (std::abs(moment.left_m - still_.left_m) < kCounted_m &&
            std::abs(moment.right_m - still_.right_m) < kCounted_m) {
            return;
        }
        still_ = moment;
        if (!travel.moved()) travel.moved_from_s = travel.moments.back().t_s;
        travel.moved_until_s = moment.t_s;
    }

    Vehicle vehicle_;
    Odometry last_{};
    EncoderMoment still_{};
};

// As reported; none: it did not stand, and the file does not say.
std::optional<double> gyroBias(std::span<const GyroSample> samples,
                               std::span<const SensorReport> reports, const Vehicle& vehicle) {
    const GyroStands standing = standsIn(samples, reports, vehicle);
    double turn_rad = 0.0;
    double span_s = 0.0;
    for (const GyroStand& stand : standing.stands) {
        turn_rad += stand.mean_rad_s * stand.span_s;
        span_s += stand.span_s;
    }
    if (span_s > 0.0) return turn_rad / span_s;
    if (vehicle.gyro_bias_rad_s) return *vehicle.gyro_bias_rad_s / vehicle.gyro_scale;
    return std::nullopt;
}

void addGyro(EncoderTravel& travel, std::span<const SensorReport> reports, const Vehicle& vehicle) {
    auto gyro = gyroSamplesOf(reports);
    if (!gyro || travel.moments.empty()) return;
    const auto samples = withoutLoneReadings(std::move(gyro->samples));
    const auto bias_rad_s = gyroBias(samples, reports, vehicle);
    travel.has_gyro = true;
    travel.knows_gyro_bias = bias_rad_s.has_value();
    double heading_rad = 0.0;
    auto sample = samples.begin();
    while (sample != samples.end() && sample->t_s <= travel.moments.front().t_s) ++sample;
    for (EncoderMoment& moment : travel.moments) {
        for (; sample != samples.end() && sample->t_s <= moment.t_s; ++sample) {
            heading_rad +=
                vehicle.gyro_scale * sample->dt_s * (sample->rate_rad_s - bias_rad_s.value_or(0.0));
        }
        moment.gyro_rad = heading_rad;
    }
}

bool travelled(const EncoderMoment& from, const EncoderMoment& to, double least_m) {
    return std::abs(to.left_m - from.left_m) >= least_m ||
           std::abs(to.right_m - from.right_m) >= least_m;
}

// Where the wheels stand still between two tests.
std::vector<double> cutTimes_s(const EncoderTravel& travel, double least_m) {
    std::vector<double> times_s;
    if (travel.moments.empty()) return times_s;
    EncoderMoment since = travel.moments.front();  // of this test
    EncoderMoment still = since;
    for (const EncoderMoment& moment : travel.moments) {
        if (!travelled(still, moment, kCounted_m)) continue;
        if (moment.t_s - still.t_s >= kBetweenTests_s && travelled(since, still, least_m)) {
            times_s.push_back(0.5 * (still.t_s + moment.t_s));
            since = still;
        }
        still = moment;
    }
    return times_s;
}

}  // namespace

bool EncoderTravel::stands() const {
    return !moments.empty() && moments.back().t_s - moved_until_s >= kStoodFor_s;
}

EncoderTravel readEncoderTravel(std::span<const SensorReport> reports, const Vehicle& vehicle) {
    EncoderReader reader(vehicle);
    for (const SensorReport& report : reports) reader.add(report);
    addGyro(reader.travel, reports, vehicle);
    return std::move(reader.travel);
}

EncoderTestLogs encoderTestsIn(const SampleSet& log, const Vehicle& vehicle, double least_m) {
    EncoderTestLogs tests;
    std::span<const SensorReport> rest(log.reports);
    for (const double t_s : cutTimes_s(readEncoderTravel(rest, vehicle), least_m)) {
        const auto later = std::find_if(
            rest.begin(), rest.end(), [t_s](const auto& each) { return each.robot_time_s > t_s; });
        const auto count = static_cast<std::size_t>(later - rest.begin());
        tests.push_back(rest.first(count));
        rest = rest.subspan(count);
    }
    tests.push_back(rest);
    return tests;
}

EncoderTestLogs encoderTestsIn(std::span<const SampleSet> logs, const Vehicle& vehicle,
                               double least_m) {
    if (logs.size() == 1) return encoderTestsIn(logs.front(), vehicle, least_m);
    EncoderTestLogs tests;
    for (const SampleSet& log : logs) tests.emplace_back(log.reports);
    return tests;
}

}  // namespace hedr
