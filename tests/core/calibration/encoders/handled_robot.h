#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/calibration/encoders/encoder_check.h"
#include "core/geometry/angle.h"
#include "core/simulation/random.h"

namespace hedr::test {

// What is wrong with a robot; as a factory makes it: nothing.
struct EncoderTrouble {
    bool swapped = false;
    double left = 1.0;  // counts, so many times what they should be
    double right = 1.0;
    double wheelbase = 1.0;  // believed over real
    double gyro = 1.0;
    double left_gap = 0.0;  // of a revolution, where it does not count
    double right_gap = 0.0;
};

// A robot of any size, and the hands that push and spin it.
class HandledRobot {
  public:
    explicit HandledRobot(std::uint64_t seed, const EncoderTrouble& trouble = {})
        : random_(seed), trouble_(trouble) {
        // Small wheels have few lines, or the files of their makers would not be believed.
        diameter_m_ = random_.uniform(0.05, 0.25);
        wheelbase_m_ = random_.uniform(1.3, 3.0) * diameter_m_ + 0.05;
        lines_ = std::round(std::exp(random_.uniform(std::log(12.0), std::log(2000.0))));
        rate_hz_ = random_.uniform(20.0, 60.0);
        left_angle_ = random_.uniform(0.0, 10.0);
        right_angle_ = random_.uniform(0.0, 10.0);
        believed.geometry = {diameter_m_ * (1.0 + 0.01 * random_.normal()),
                             diameter_m_ * (1.0 + 0.01 * random_.normal()),
                             wheelbase_m_ * trouble.wheelbase * (1.0 + 0.015 * random_.normal()),
                             lines_};
        gyro_bias_rad_s_ = radFromDeg(0.5) * random_.normal();
        has_gyro = random_.uniform() < 0.7 || trouble.gyro < 0.0;
    }

    // Straight on, nearly: steps, and a heading that wanders.
    void push(double distance_m) {
        begin();
        const double true_m = distance_m + 0.007 * random_.normal();
        const double speed_m_s = random_.uniform(0.15, 0.4);
        const double turned_rad = radFromDeg(1.5) * random_.normal();
        move(true_m, turned_rad, std::abs(true_m) / speed_m_s, 0.1 * speed_m_s, wander_rad_s);
        stand(1.5);
    }
    void spin(double turns) {
        begin();
        const double turn_rad = 2.0 * kPi * turns + radFromDeg(3.0) * random_.normal();
        const double speed_rad_s = radFromDeg(random_.uniform(30.0, 80.0));
        move(0.01 * random_.normal(), turn_rad, std::abs(turn_rad) / speed_rad_s, 0.02,
             0.15 * speed_rad_s);
        stand(1.5);
    }

    EncoderCheck check(const EncoderCheckOptions& options = {}) const {
        return checkEncoders(sets, believed, options);
    }

    double revolution_m() const { return kPi * diameter_m_; }
    double lines() const { return lines_; }
    void setLines(double lines) { believed.geometry.ticks_per_revolution = lines_ = lines; }
    Random& random() { return random_; }

    Vehicle believed{};
    bool has_gyro = true;
    double wander_rad_s = radFromDeg(4.0);  // of the heading, while it is pushed
    std::vector<SampleSet> sets{};

  private:
    void begin() {
        sets.push_back({});
        stand(2.5);
    }
    void stand(double time_s) {
        for (double until_s = time_s_ + time_s; time_s_ < until_s;) step(0.0, 0.0);
    }
    void move(double distance_m, double turn_rad, double time_s, double unsteady_m_s,
              double unsteady_rad_s) {
        const auto steps = static_cast<int>(std::ceil(time_s * rate_hz_)) + 2;
        CorrelatedNoise along(0.4, 1.0 / rate_hz_);
        CorrelatedNoise around(0.4, 1.0 / rate_hz_);
        std::vector<double> paths;
        std::vector<double> turns;
        double path_m = 0.0;
        double angle_rad = 0.0;
        double shape_sum = 0.0;
        for (int i = 0; i < steps; ++i) shape_sum += shape(i, steps);
        for (int i = 0; i < steps; ++i) {
            const double soft = std::min(1.0, 3.0 * shape(i, steps));
            paths.push_back(soft * unsteady_m_s * along.next(random_) / rate_hz_);
            turns.push_back(soft * unsteady_rad_s * around.next(random_) / rate_hz_);
            path_m += paths.back();
            angle_rad += turns.back();
        }
        for (int i = 0; i < steps; ++i) {
            const double share = shape(i, steps) / shape_sum;
            step(paths[static_cast<std::size_t>(i)] + share * (distance_m - path_m),
                 turns[static_cast<std::size_t>(i)] + share * (turn_rad - angle_rad));
        }
    }
    static double shape(int i, int steps) {
        const double way = (i + 0.5) / steps;
        return std::min(1.0, 8.0 * std::min(way, 1.0 - way));
    }
    void step(double distance_m, double turn_rad) {
        const double half_m = 0.5 * wheelbase_m_ * turn_rad;
        left_angle_ += (distance_m - half_m) / revolution_m();
        right_angle_ += (distance_m + half_m) / revolution_m();
        time_s_ += 1.0 / rate_hz_;
        SensorReport report{.robot_time_s = time_s_};
        const std::int64_t left = counts(left_angle_, trouble_.left, trouble_.left_gap);
        const std::int64_t right = counts(right_angle_, trouble_.right, trouble_.right_gap);
        report.odometry = trouble_.swapped ? WheelTicks{right, left} : WheelTicks{left, right};
        if (has_gyro) {
            report.gyro = GyroRate{trouble_.gyro * (turn_rad * rate_hz_) + gyro_bias_rad_s_ +
                                   radFromDeg(0.1) * random_.normal()};
        }
        sets.back().reports.push_back(report);
    }
    // Of a disc that lacks the lines of its first part.
    std::int64_t counts(double angle, double factor, double gap) const {
        const double whole = std::floor(angle);
        const double missing = std::round(gap * lines_);
        const double line = std::floor((angle - whole) * lines_);
        const double counted = whole * (lines_ - missing) + std::max(0.0, line - missing);
        return std::llround(factor * counted);
    }

    Random random_;
    EncoderTrouble trouble_;
    double diameter_m_ = 0.0;
    double wheelbase_m_ = 0.0;
    double lines_ = 0.0;
    double rate_hz_ = 0.0;
    double left_angle_ = 0.0;
    double right_angle_ = 0.0;
    double gyro_bias_rad_s_ = 0.0;
    double time_s_ = 0.0;
};

struct EncoderFaultCase {
    const char* name;
    EncoderTrouble trouble{};
    std::vector<std::pair<EncoderFault, EncoderSide>> findings{};
    // Pushed by six revolutions, and steadily where there is no gyro; sixteen lines or more.
    bool far = false;
};

inline EncoderCheck checked(const EncoderFaultCase& fault, std::uint64_t seed) {
    HandledRobot robot(seed, fault.trouble);
    EncoderCheckOptions options;
    options.distance_m = robot.random().uniform() < 0.5 ? 1.0 : -1.0;
    options.turns = robot.random().uniform() < 0.5 ? 1.0 : -1.0;
    if (fault.far) {
        options.distance_m *= std::ceil(6.0 * robot.revolution_m());
        robot.setLines(std::max(16.0, robot.lines()));
        if (!robot.has_gyro) robot.wander_rad_s = radFromDeg(0.5);
    }
    robot.push(options.distance_m);
    robot.spin(options.turns);
    return robot.check(options);
}

}  // namespace hedr::test
